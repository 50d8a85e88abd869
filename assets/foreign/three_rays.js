// Shadows by rays, for shadows=rays: the ray of each pixel finds a point of a surface, and a ray from there to a light whether anything stands
// between. Both meet triangles by THREE.Ray, in double precision. Shading is that of three.js, each light drawn by itself, at the points that were found.

const LEAF = 4; // triangles in a box that is not halved again; boxes for less cost more than they save

// Coordinates are floats, good to 2^-24 of their size; a distance from a plane is made of a few of them.
const roundingOf = triangles => 2 ** -22 * Math.max(...triangles.box.min.toArray().map(Math.abs), ...triangles.box.max.toArray().map(Math.abs));

// Which texels of an image are solid, rows from the top.
function solidTexels(image) {
  const paint = new OffscreenCanvas(image.width, image.height).getContext("2d");
  paint.drawImage(image, 0, 0);
  return paint.getImageData(0, 0, image.width, image.height).data.filter((_, i) => i % 4 === 3).map(alpha => Number(alpha >= 128));
}

function trianglesOf(mesh, images) {
  const vectors = (text, size) => {
    const all = numbers(text ?? "");
    return Array.from({length: all.length / size}, (_, i) => size === 3 ? vector(all.slice(3 * i, 3 * i + 3)) : new THREE.Vector2(...all.slice(2 * i, 2 * i + 2)));
  };
  const {holes, image: number, clamped} = SCENE.materials[mesh.material], image = images[number];
  const surface = {normal: vectors(mesh.normals, 3), uv: vectors(mesh.texcoords, 2), color: vectors(mesh.colors, 3),
                   mask: holes && {solid: solidTexels(image), width: image.width, height: image.height, clamped}};
  const positions = vectors(mesh.positions, 3);
  return vectors(mesh.triangles, 3).map(numbersOfCorners => {
    const corners = numbersOfCorners.toArray(), [a, b, c] = corners.map(corner => positions[corner]);
    return {mesh, surface, corners, a, b, c, sum: a.clone().add(b).add(c), plane: new THREE.Plane().setFromCoplanarPoints(a, b, c)};
  });
}

// What a surface has at a place of its triangle: its normal, uv or color.
const interpolated = ({surface, corners, a, b, c}, name, place) => {
  const values = corners.map(corner => surface[name][corner]);
  return THREE.Triangle.getInterpolation(place, a, b, c, ...values, values[0].clone());
};

// A tree of boxes: of triangles in their order along the box's longest side one half goes into each of two smaller boxes.
function boxesOf(triangles) {
  const box = new THREE.Box3().setFromPoints(triangles.flatMap(({a, b, c}) => [a, b, c]));
  if (triangles.length <= LEAF) return {box, triangles};
  const size = box.getSize(new THREE.Vector3()), axis = ["x", "y", "z"].reduce((longest, axis) => size[axis] > size[longest] ? axis : longest);
  const sorted = triangles.toSorted((p, q) => p.sum[axis] - q.sum[axis]), half = sorted.length >> 1; // a sum of corners is three times the middle
  return {box, halves: [boxesOf(sorted.slice(0, half)), boxesOf(sorted.slice(half))]};
}

// The nearest texel decides, as in the page's alpha map.
function isInHole(triangle, place) {
  const mask = triangle.surface.mask;
  if (!mask) return false;
  const at = interpolated(triangle, "uv", place);
  const texel = (share, count) => {
    const index = Math.floor(share * count);
    return mask.clamped ? THREE.MathUtils.clamp(index, 0, count - 1) : THREE.MathUtils.euclideanModulo(index, count);
  };
  return !mask.solid[(mask.height - 1 - texel(at.y, mask.height)) * mask.width + texel(at.x, mask.width)];
}

// Calls `onHit` with each triangle that the ray meets, from either side, and the place, in no order, until it returns true.
function meets(boxes, ray, onHit) {
  if (!ray.intersectsBox(boxes.box)) return false;
  if (boxes.halves) return boxes.halves.some(half => meets(half, ray, onHit));
  return boxes.triangles.some(triangle => {
    const place = ray.intersectTriangle(triangle.a, triangle.b, triangle.c, false, new THREE.Vector3());
    return place && !isInHole(triangle, place) && onHit(triangle, place);
  });
}

// The nearest point of a surface on the ray of each pixel, rows from the top; null where there is none.
function seenPoints(boxes) {
  const {position, right, up, back, fovYDegrees, near} = SCENE.camera, eye = vector(position), forward = vector(back).negate();
  const t = Math.tan(THREE.MathUtils.degToRad(fovYDegrees) / 2);
  return Array.from({length: width * height}, (_, pixel) => {
    const x = pixel % width, y = Math.floor(pixel / width); // its centre is half a pixel further
    const direction = forward.clone().addScaledVector(vector(right), t * width / height * (2 * (x + 0.5) / width - 1))
      .addScaledVector(vector(up), t * (1 - 2 * (y + 0.5) / height));
    let seen = null, depth = Infinity;
    meets(boxes, new THREE.Ray(eye, direction.normalize()), (triangle, place) => {
      const ahead = place.clone().sub(eye).dot(forward);
      if (ahead > near && ahead < depth) [seen, depth] = [{pixel, triangle, place, isFront: triangle.plane.distanceToPoint(eye) > 0}, ahead];
    });
    return seen;
  });
}

const towardLight = (light, place) => light.type === "directional" ? vector(light.direction).negate() : vector(light.position).sub(place);

// The share of a light's strength that goes to a point of a surface if nothing stands between: 0 where the triangle turns its other side to the light.
function shareOf(light, {triangle, place, isFront}) {
  const toward = towardLight(light, place).normalize(), fromLight = toward.clone().negate();
  if (SCENE.lights[triangle.mesh.emitterOfLight] === light || toward.dot(triangle.plane.normal) > 0 !== isFront) return 0;
  if (light.normal) return Math.max(0, fromLight.dot(vector(light.normal))); // a panel shines to its front, by the cosine
  if (light.type !== "spot") return 1;
  const inside = light.coneDegrees / 2 - THREE.MathUtils.radToDeg(fromLight.angleTo(vector(light.direction)));
  return light.edgeDegrees > 0 ? THREE.MathUtils.smoothstep(inside, 0, light.edgeDegrees) : Number(inside > 0);
}

// A triangle stands between a point and a light where its plane does, by more than rounding. So neither the surface's own plane counts, with what
// lies in it, nor one that holds the lamp.
function isBlocked(boxes, rounding, light, {triangle: {mesh}, place: from}) {
  const toward = towardLight(light, from), lamp = from.clone().add(toward);
  if (!mesh.receivesShadow) return false;
  return meets(boxes, new THREE.Ray(from, toward.clone().normalize()), ({mesh: other, plane}) => {
    const side = plane.distanceToPoint(from);
    return other.castsShadow && Math.abs(side) > rounding && (light.type === "directional" || -Math.sign(side) * plane.distanceToPoint(lamp) > rounding);
  });
}

// Draws the points that were found on one side of a mesh, each at the centre of its pixel. The mesh itself could cover the centre by a hair
// more or less than the ray meets.
function addPoints(world, mesh, isFront, points, images) {
  const geometry = new THREE.BufferGeometry();
  const attribute = (name, size, value) => geometry.setAttribute(name, new THREE.Float32BufferAttribute(points.flatMap(value), size));
  attribute("position", 3, ({place}) => place.toArray());
  attribute("normal", 3, ({triangle, place}) => interpolated(triangle, "normal", place).multiplyScalar(isFront ? 1 : -1).toArray());
  for (const [name, size, list] of [["uv", 2, mesh.texcoords], ["color", 3, mesh.colors]])
    if (list) attribute(name, size, ({triangle, place}) => interpolated(triangle, name, place).toArray());
  attribute("centre", 2, ({pixel}) => [2 * (pixel % width + 0.5) / width - 1, 1 - 2 * (Math.floor(pixel / width) + 0.5) / height]);
  const source = SCENE.materials[mesh.material], shines = source.emission && (isFront || source.emits !== "front");
  const made = material({...source, holes: false}, images, Boolean(mesh.colors), THREE.FrontSide, {radiance: shines ? source.emission : [0, 0, 0]});
  made.onBeforeCompile = shader => {
    shader.vertexShader = "attribute vec2 centre;\n" + shader.vertexShader.replace("#include <project_vertex>",
      "#include <project_vertex>\ngl_Position = vec4(centre, 0.0, 1.0);\ngl_PointSize = 1.0;");
  };
  world.add(Object.assign(new THREE.Points(geometry, made), {frustumCulled: false}));
}

// One lamp of three.js for a light, without cone, front and shadow: shareOf has the first two.
function bareLight({type, color: shade, intensity, pointIntensity, direction, position}) {
  const strength = (pointIntensity ?? intensity) * exposure;
  const lamp = type === "directional" ? new THREE.DirectionalLight(color(shade), strength) : new THREE.PointLight(color(shade), strength, 0, 2);
  lamp.position.copy(type === "directional" ? vector(direction).negate() : vector(position));
  return lamp;
}

// `shining` shine; of them the `shadowing` cast shadows. Returns the canvas.
function pictureByRays(renderer, world, camera, images, shining, shadowing) {
  const triangles = boxesOf(SCENE.meshes.flatMap(mesh => trianglesOf(mesh, images))), rounding = roundingOf(triangles), points = seenPoints(triangles);
  const arriving = (light, point) => {
    const share = point ? shareOf(light, point) : 0;
    return share > 0 && shadowing.has(light) && isBlocked(triangles, rounding, light, point) ? 0 : share;
  };
  if (white) return shown(renderer, pixel => points[pixel] ? Array(3).fill(arriving(shining[0], points[pixel]) > 0 ? 255 : 0) : null);
  for (const mesh of SCENE.meshes)
    for (const isFront of [true, false]) {
      const found = points.filter(point => point && point.triangle.mesh === mesh && point.isFront === isFront);
      if (found.length) addPoints(world, mesh, isFront, found, images);
    }
  const dark = linearPixels(renderer, world, camera), sum = Float64Array.from(dark); // ambient light and what shines by itself
  for (const light of shining) {
    const lamp = bareLight(light);
    world.add(lamp);
    const lit = linearPixels(renderer, world, camera);
    world.remove(lamp);
    points.forEach((point, pixel) => {
      const share = arriving(light, point);
      for (let at = 4 * pixel; at < 4 * pixel + 3; ++at) sum[at] += share * (lit[at] - dark[at]);
    });
  }
  const encoded = value => 255 * THREE.MathUtils.clamp(new THREE.Color(value, 0, 0).convertLinearToSRGB().r, 0, 1);
  return shown(renderer, pixel => Array.from(sum.subarray(4 * pixel, 4 * pixel + 3), encoded));
}
