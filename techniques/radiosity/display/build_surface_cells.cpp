// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "techniques/radiosity/display/surface_cells.h"

namespace shadowlab::radiosity {

namespace {

// Faces within this share of their size from a plane lie in it: simplified vertices are floats, found by solving small systems of
// equations.
constexpr double kOnePlane = 1e-5;

// 2.5 degrees, by which kOffPlane can tilt a triangle of a cell's size.
constexpr double kSamePlaneCosine = 0.999;

// 45 degrees: the limit for facing the same way.
constexpr double kSameWayCosine = 0.7;

class CellBuilder {
public:
    CellBuilder(const scene::Scene& drawn, const Room& room) : drawn_(drawn), room_(room), patches_(room.allPatches()) {
        cells_.corners = patchCorners(room.sides().faces, patches_);
        firstBlend_ = cells_.corners.count() + patches_.size();
    }

    SurfaceCells build() {
        findPlanes();
        for (std::uint32_t i = 0; i < patches_.size(); ++i)
            addCell(i);
        buildTrees();
        for (std::size_t object = 0; object < drawn_.objects.size(); ++object)
            addObject(object);
        for (const PatchTree::Node& node : tree_.nodes) {
            cells_.lines.emplace_back(vec3(node.line), 0.0f);
            cells_.branches.emplace_back(node.front, node.behind, 0, 0);
        }
        return std::move(cells_);
    }

private:
    [[nodiscard]] const FaceFrame& frame(std::uint32_t side) const { return planes_[planeOfSide_[side] / 2].frame; }

    /// Finds the planes of each object; all faces in a plane, from both sides, share its coordinates.
    void findPlanes() {
        const std::vector<Face>& all = room_.sides().faces.all;
        std::vector<std::vector<std::uint32_t>> ofObject(drawn_.objects.size());
        for (const Face& side : all) {
            std::vector<std::uint32_t>& known = ofObject[side.object];
            const double tolerance = kOnePlane * sizeOf(side.polygon);
            const auto found = std::ranges::find_if(known, [&](std::uint32_t p) {
                const Plane &plane = planes_[p].plane, turned{plane.point, -plane.normal};
                return isBehind(plane, side.polygon, tolerance) && isBehind(turned, side.polygon, tolerance);
            });
            const bool isNew = found == known.end();
            const auto plane = isNew ? static_cast<std::uint32_t>(planes_.size()) : *found;
            if (isNew) {
                known.push_back(plane);
                planes_.push_back({side.plane, frameOf(side.polygon)});
            }
            const bool isTurned = glm::dot(planes_[plane].plane.normal, side.plane.normal) < 0;
            planeOfSide_.push_back(2 * plane + (isTurned ? 1 : 0));
        }
    }

    void addCell(std::uint32_t patch) {
        const FaceFrame& to = frame(patches_[patch].face);
        const std::uint32_t first = borders().first[patch], end = borders().first[patch + 1];
        cells_.cells.emplace_back(patch, cells_.borders.size(), end - first, patch + 1);
        cells_.frames.push_back(to);
        addBorder(to.place(patches_[patch].centre), cells_.corners.count() + patch);
        for (std::uint32_t piece = first; piece < end; ++piece)
            addBorder(to.place(pointOf(piece)), cells_.corners.cornerOfPiece[piece]);
    }
    [[nodiscard]] const PatchBorders& borders() const { return cells_.corners.borders; }
    /// The point where a piece of border begins.
    [[nodiscard]] const dvec3& pointOf(std::uint32_t piece) const {
        return borders().pointsCentred[borders().pieces[piece].point];
    }
    void addBorder(const dvec2& place, std::size_t value) {
        cells_.borders.emplace_back(vec2(place), static_cast<float>(value), 0.0f);
    }

    void buildTrees() {
        std::vector<std::vector<FlatPolygon>> inPlane(2 * planes_.size());
        std::vector<double> touching(inPlane.size(), 0.0);
        for (std::uint32_t p = 0; p < patches_.size(); ++p) {
            const std::uint32_t side = patches_[p].face, plane = planeOfSide_[side];
            FlatPolygon& flat = inPlane[plane].emplace_back();
            flat.number = p;
            for (const dvec3& corner : patches_[p].polygon.corners())
                flat.corners.push_back(frame(side).place(corner));
            touching[plane] = std::max(touching[plane], kTouching * sizeOf(room_.sides().faces.all[side].polygon));
        }
        for (std::size_t plane = 0; plane < inPlane.size(); ++plane)
            roots_.push_back(inPlane[plane].empty() ? SurfaceCells::kNone
                                                    : addTree(tree_, inPlane[plane], touching[plane]));
    }

    void addObject(std::size_t number) {
        const scene::Object& object = drawn_.objects[number];
        const scene::Mesh& mesh = *object.mesh;
        const auto& places = room_.simple().cornersOfObject[number];
        const std::uint32_t first = room_.world().firstOfObject[number];
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        vertexNumbers_.clear();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            cells_.roots.emplace_back(SurfaceCells::kNone, SurfaceCells::kNone, 0, 0);
            if (object.emitterOfLight >= 0) {
                addPlaces({}, worldFromMesh);
            } else if (places.empty()) {
                const std::size_t triangle = first + t;
                const std::uint32_t front = room_.sides().faces.ofTriangle[triangle],
                                    back = room_.sides().backOfTriangle[triangle];
                cells_.roots.back().x = rootOf(front);
                cells_.roots.back().y = rootOf(back);
                addPlaces(front != kNoFace ? frame(front) : back != kNoFace ? frame(back) : FaceFrame{}, worldFromMesh);
            } else {
                Polygon polygon;
                for (int i = 0; i < 3; ++i)
                    polygon.add(transformPoint(worldFromMesh, dvec3(mesh.positionsMesh[mesh.triangles[t][i]])) -
                                room_.world().originWorld);
                if (const auto plane = planeOf(polygon, places[t])) {
                    addPlaces(planes_[*plane / 2].frame, worldFromMesh);
                    cells_.roots.back().x = roots_[*plane];
                    cells_.roots.back().y = roots_[*plane ^ 1];
                    continue;
                }
                const FaceFrame own = frameOf(polygon);
                addPlaces(own, worldFromMesh);
                cells_.roots.back().x = blendedCell({polygon, own, number, mesh.triangles[t], false}, places[t]);
                cells_.roots.back().y = blendedCell({polygon, own, number, mesh.triangles[t], true}, places[t]);
            }
        }
    }
    [[nodiscard]] std::uint32_t rootOf(std::uint32_t side) const {
        return side == kNoFace ? SurfaceCells::kNone : roots_[planeOfSide_[side]];
    }

    /// The plane of the simplified mesh (its front) in which the triangle lies, if there is one.
    [[nodiscard]] std::optional<std::uint32_t> planeOf(const Polygon& triangle,
                                                       const std::array<SurfacePlace, 3>& places) const {
        std::optional<std::uint32_t> plane;
        // Small enough to be interpolated between its corners.
        if (sizeOf(triangle) < room_.simple().cellMetres) return plane;
        const dvec3 normal = glm::normalize(areaVector(triangle));
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t side = room_.sides().faces.ofTriangle[places[i].triangle];
            if (rootOf(side) == SurfaceCells::kNone || (plane && *plane != planeOfSide_[side])) return std::nullopt;
            plane = planeOfSide_[side];
            if (glm::dot(room_.sides().faces.all[side].plane.normal, normal) < kSamePlaneCosine) return std::nullopt;
            if (std::abs(planes_[*plane / 2].plane.height(triangle[i])) > kOffPlane * room_.simple().cellMetres)
                return std::nullopt;
        }
        return plane;
    }

    void addPlaces(const FaceFrame& to, const dmat4& worldFromMesh) {
        // Two rows of the matrix from mesh positions to u and v, composed in double.
        const dvec3 origin = transformPoint(worldFromMesh, dvec3(0)) - room_.world().originWorld;
        for (const dvec3& axis : {to.u, to.v})
            cells_.places.emplace_back(vec3(axis * dmat3(worldFromMesh)),
                                       static_cast<float>(glm::dot(axis, origin - to.originCentred)));
    }

    /// One side of an original triangle whose mesh was simplified.
    struct DrawnTriangle {
        const Polygon& polygon;
        const FaceFrame& frame;
        std::size_t object;
        const uvec3& vertices;
        bool isBack;
    };
    std::uint32_t blendedCell(const DrawnTriangle& triangle, const std::array<SurfacePlace, 3>& places) {
        const Sides& sides = room_.sides();
        std::array<SurfaceCells::Blend, 3> blends;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto blend = blendAt(places[i], triangle.isBack ? sides.backOfTriangle : sides.faces.ofTriangle);
            if (!blend) return SurfaceCells::kNone;
            blends[i] = *blend;
            blends[i].vertex = vertexNumber(triangle, i);
        }
        const auto cell = static_cast<std::uint32_t>(cells_.cells.size());
        // The patch of two of its corners, if they agree.
        const std::uint32_t patch = blends[1].patch == blends[2].patch ? blends[1].patch : blends[0].patch;
        cells_.cells.emplace_back(patch, cells_.borders.size(), 3, 0);
        addBorder(triangle.frame.place(centroid(triangle.polygon)), firstBlend_ + cells_.blends.size() + 3);
        for (std::size_t i = 0; i < 3; ++i)
            addBorder(triangle.frame.place(triangle.polygon[i]), firstBlend_ + cells_.blends.size() + i);
        cells_.blends.insert(cells_.blends.end(), blends.begin(), blends.end());
        cells_.blends.push_back({patch, {}, {1, 0, 0}, blends[0].vertex});
        return PatchTree::kLeaf | cell;
    }

    std::uint32_t vertexNumber(const DrawnTriangle& triangle, std::size_t corner) {
        const std::uint32_t vertex = triangle.vertices[static_cast<int>(corner)];
        const auto next = static_cast<std::uint32_t>(cells_.vertices.size());
        const auto [known, isNew] = vertexNumbers_.try_emplace({vertex, triangle.isBack}, next);
        if (isNew) {
            const scene::Object& object = drawn_.objects[triangle.object];
            const dmat3 normalFromMesh = glm::transpose(glm::inverse(dmat3(scene::worldFromMesh(object))));
            const dvec3 facing = (triangle.isBack ? -1.0 : 1.0) * areaVector(triangle.polygon);
            dvec3 normal = normalFromMesh * dvec3(object.mesh->normalsMesh[vertex]);
            if (glm::dot(normal, facing) < 0) normal = -normal;
            cells_.vertices.push_back(
                {triangle.polygon[corner], glm::normalize(normal), static_cast<std::uint32_t>(triangle.object)});
        }
        return known->second;
    }

    std::optional<SurfaceCells::Blend> blendAt(const SurfacePlace& place,
                                               const std::vector<std::uint32_t>& sideOfTriangle) const {
        const std::uint32_t side = sideOfTriangle[place.triangle];
        if (side == kNoFace) return std::nullopt;
        const trace::Triangle& t = room_.world().triangles[place.triangle];
        const dvec3 position = dmat3(t.a, t.b, t.c) * dvec3(place.weights[0], place.weights[1], place.weights[2]);
        if (rootOf(side) != SurfaceCells::kNone) {
            const dvec2 at = frame(side).place(position);
            return blendIn(find(tree_, rootOf(side), at), at);
        }
        const std::optional<std::uint32_t> nearest = nearestPatch(room_.sides().faces.all[side], position);
        if (!nearest) return std::nullopt;
        const std::uint32_t corner = cells_.corners.cornerOfPiece[borders().first[*nearest]]; // its weight is 0
        return SurfaceCells::Blend{*nearest, {corner, corner}, {1, 0, 0}};
    }

    /// If no patch of a side is left: among the object's patches that face the same way, the one with the nearest centre.
    [[nodiscard]] std::optional<std::uint32_t> nearestPatch(const Face& side, const dvec3& position) const {
        std::optional<std::uint32_t> nearest;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < patches_.size(); ++i) {
            const double distance = glm::distance(patches_[i].centre, position);
            if (distance >= least || room_.faceOf(patches_[i]).object != side.object ||
                glm::dot(patches_[i].normal, side.plane.normal) < kSameWayCosine)
                continue;
            least = distance;
            nearest = i;
        }
        return nearest;
    }

    /// The triangle of the patch's fan that contains the place, and its barycentric weights.
    [[nodiscard]] SurfaceCells::Blend blendIn(std::uint32_t patch, const dvec2& at) const {
        const FaceFrame& to = frame(patches_[patch].face);
        const std::uint32_t first = borders().first[patch], end = borders().first[patch + 1];
        const dvec2 centre = to.place(patches_[patch].centre);
        SurfaceCells::Blend best{patch, {}, {1, 0, 0}};
        double bestInside = -1e300;
        for (std::uint32_t piece = first; piece < end; ++piece) {
            const std::uint32_t next = borders().after(piece);
            const dvec2 toA = to.place(pointOf(piece)) - centre, toB = to.place(pointOf(next)) - centre;
            const auto cross = [](const dvec2& p, const dvec2& q) { return p.x * q.y - p.y * q.x; };
            const double area = cross(toA, toB);
            if (area == 0) continue;
            const double weightA = cross(at - centre, toB) / area, weightB = cross(toA, at - centre) / area;
            if (const double inside = std::min(weightA, weightB); inside > bestInside) {
                bestInside = inside;
                // By rounding, a place on the border may lie outside.
                const double sum = std::max(1.0, weightA + weightB);
                best = {patch,
                        {cells_.corners.cornerOfPiece[piece], cells_.corners.cornerOfPiece[next]},
                        {0, std::max(0.0, weightA / sum), std::max(0.0, weightB / sum)}};
                best.weights.x = 1 - best.weights.y - best.weights.z;
            }
        }
        return best;
    }

    const scene::Scene& drawn_;
    const Room& room_;
    const std::vector<Patch>& patches_;
    SurfaceCells cells_;
    PatchTree tree_;
    struct ObjectPlane {
        Plane plane;
        FaceFrame frame;
    };
    std::vector<ObjectPlane> planes_;
    std::vector<std::uint32_t> planeOfSide_; ///< twice the plane's number, plus one for its back
    std::vector<std::uint32_t> roots_;       ///< by plane and side, numbered as in planeOfSide_
    std::size_t firstBlend_ = 0;
    /// Of the current object, by vertex and side.
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> vertexNumbers_;
};

} // namespace

SurfaceCells surfaceCells(const scene::Scene& drawn, const Room& room) { return CellBuilder(drawn, room).build(); }

} // namespace shadowlab::radiosity
