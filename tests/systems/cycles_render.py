"""Run inside Blender: draws what `cycles_scenes.for_blender` wrote, by Cycles, and writes linear radiance.

blender -b --factory-startup --python cycles_render.py -- JOBS.json

JOBS.json is a list of {scene, samples, seed, output}. Output: three floats of 32 bits a pixel, rows from the top.

Units. A polygon's emission shader of strength S has the radiance S. A sun of strength E brings the irradiance E to what is square to
it. A point lamp of P watts shares them out evenly over the 4 pi of all directions, so its radiant intensity is P / (4 pi).
`cycles_check.py` holds all three against closed forms before anything is compared."""
# SPDX-License-Identifier: MIT
import array
import json
import math
import sys
from pathlib import Path

import bpy
from mathutils import Matrix, Vector

WATTS_OF_INTENSITY = 4 * math.pi
BOUNCES = 256  # of 0.9 each time less than a millionth is left
ONE_POINT = 0.01  # pixels: the narrowest filter there is, so that all rays of a pixel go through its centre, as ours do


def material_of(reflectance, radiance):
    """A dull surface on both sides that shines from its front alone."""
    material = bpy.data.materials.new("dull")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    out, diffuse = nodes.new("ShaderNodeOutputMaterial"), nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*reflectance, 1)
    diffuse.inputs["Roughness"].default_value = 0  # Lambert's law
    if not any(radiance):
        links.new(diffuse.outputs[0], out.inputs["Surface"])
        return material
    side, front = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeMath")
    emission, both = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeAddShader")
    front.operation = "SUBTRACT"
    front.inputs[0].default_value = 1
    links.new(side.outputs["Backfacing"], front.inputs[1])
    links.new(front.outputs[0], emission.inputs["Strength"])
    emission.inputs["Color"].default_value = (*radiance, 1)
    links.new(diffuse.outputs[0], both.inputs[0])
    links.new(emission.outputs[0], both.inputs[1])
    links.new(both.outputs[0], out.inputs["Surface"])
    return material


def put(name, data, matrix=None):
    thing = bpy.data.objects.new(name, data)
    if matrix:
        thing.matrix_world = matrix
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_polygons(polygons):
    for polygon in polygons:
        mesh = bpy.data.meshes.new("polygon")
        mesh.from_pydata(polygon["corners"], [], [range(len(polygon["corners"]))])
        mesh.materials.append(material_of(polygon["reflectance"], polygon["radiance"]))
        put("polygon", mesh)


def add_lamp(lamp):
    strength = max(lamp["color"])
    if lamp["type"] == "directional":
        light = bpy.data.lights.new("sun", "SUN")
        light.energy, light.angle = strength, 0
        matrix = Vector(lamp["direction"]).to_track_quat("-Z", "Y").to_matrix().to_4x4()
    else:
        light = bpy.data.lights.new("bulb", "POINT")
        light.energy, light.shadow_soft_size = strength * WATTS_OF_INTENSITY, 0
        matrix = Matrix.Translation(lamp["position"])
    light.color = [c / strength for c in lamp["color"]]
    put(light.name, light, matrix)


def add_eye(eye):
    camera = bpy.data.cameras.new("eye")
    camera.sensor_fit, camera.angle = "VERTICAL", eye["fovY"]
    camera.clip_start, camera.clip_end = 0.001, 1e5
    axes = zip(eye["right"], eye["up"], eye["back"], eye["position"])
    bpy.context.scene.camera = put("eye", camera, Matrix([*map(list, axes), [0, 0, 0, 1]]))


def set_up(scene, size, samples, seed):
    render, cycles = scene.render, scene.cycles
    render.engine, cycles.device = "CYCLES", "CPU"
    render.resolution_x, render.resolution_y, render.resolution_percentage = *size, 100
    render.film_transparent = render.use_compositing = render.use_sequencer = False
    cycles.samples, cycles.seed = samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_fast_gi = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = cycles.blur_glossy = 0
    cycles.max_bounces = cycles.diffuse_bounces = BOUNCES
    cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", ONE_POINT
    scene.view_settings.view_transform, scene.view_settings.look = "Raw", "None"
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    render.image_settings.color_mode, render.image_settings.exr_codec = "RGB", "NONE"


def set_background(scene, color):
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value, sky.inputs["Strength"].default_value = (*color, 1), 1


def write_radiance(exr, output):
    image = bpy.data.images.load(exr)
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    values, channels = image.pixels[:], image.channels
    picture = array.array("f")
    for y in reversed(range(height)):  # Blender's rows begin at the bottom
        for x in range(width):
            at = (y * width + x) * channels
            picture.extend(values[at:at + 3])
    Path(output).write_bytes(picture.tobytes())


def draw(job):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene, wanted = bpy.context.scene, job["scene"]
    set_up(scene, wanted["size"], job["samples"], job["seed"])
    set_background(scene, wanted["background"])
    add_polygons(wanted["polygons"])
    for lamp in wanted["lamps"]:
        add_lamp(lamp)
    add_eye(wanted["eye"])
    scene.render.filepath = job["output"] + ".exr"
    bpy.ops.render.render(write_still=True)
    write_radiance(job["output"] + ".exr", job["output"])


if __name__ == "__main__":
    for one in json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text(encoding="utf-8")):
        draw(one)
