// SPDX-License-Identifier: MIT
#include "app/foreign/calibration_board.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/foreign/camera_code.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::foreign {

namespace {

/// The angles by which an object is turned about world x, then y, then z.
dvec3 anglesDegrees(const dmat3& worldFromObject) {
    // The matrix is Rz Ry Rx: its first column is (cos y cos z, cos y sin z, -sin y).
    const double y = std::asin(std::clamp(-worldFromObject[0][2], -1.0, 1.0));
    const double cosY = std::hypot(worldFromObject[0][0], worldFromObject[0][1]);
    // Looking along x, turns about x and z are one: z keeps all of it.
    constexpr double kGimbalLock = 1e-9;
    const double x = cosY > kGimbalLock ? std::atan2(worldFromObject[1][2], worldFromObject[2][2]) : 0.0;
    const double z = cosY > kGimbalLock ? std::atan2(worldFromObject[0][1], worldFromObject[0][0])
                                        : std::atan2(-worldFromObject[1][0], worldFromObject[1][1]);
    return glm::degrees(dvec3(x, y, z));
}

double distanceOf(const scene::Camera& camera, bool isFar) {
    // Twice the near plane keeps rounding from clipping; the far plane clips in renderers that have one.
    const double wanted = glm::length(camera.targetWorld - camera.positionWorld);
    const double usual = std::min(std::max(wanted, 2 * camera.near), std::max(0.5 * camera.far, 1.01 * camera.near));
    // Half as far again: from a place that is off by a hundredth of the distance, far squares move a pixel less than near ones.
    return isFar ? std::min(1.5 * usual, 0.5 * (usual + camera.far)) : usual;
}

double metresPerPixelAt(double distance, const scene::Camera& camera, ivec2 size) {
    return 2 * distance * std::tan(glm::radians(camera.fovYDegrees) / 2) / size.y;
}

/// In view space.
dvec3 placeAt(double distance, const dvec2& px, const scene::Camera& camera, ivec2 size) {
    const double metresPerPixel = metresPerPixelAt(distance, camera, size);
    const dvec2 offsetPx = px - 0.5 * dvec2(size);
    return {offsetPx.x * metresPerPixel, -offsetPx.y * metresPerPixel, -distance};
}

/// One more rectangle, `distance` from the eye.
void addPatch(scene::Scene& board, const BoardPatch& patch, double distance, const scene::Camera& camera, ivec2 size) {
    scene::Material material;
    material.name = "patch-" + std::to_string(board.objects.size() + 1);
    material.diffuse = vec3(0.0f);
    material.emission = vec3(patch.radiance);
    material.emits = scene::EmittingSides::both;

    // A quad lies in xz and faces +y; here its x runs to the right of the picture, turned, and its y toward the eye.
    const dmat3 worldFromView = glm::transpose(dmat3(scene::viewFromWorld(camera)));
    const double angle = glm::radians(patch.turnedDegrees);
    const dvec3 right = worldFromView * dvec3(std::cos(angle), std::sin(angle), 0.0), towardEye = worldFromView[2];
    const dmat3 worldFromQuad(right, towardEye, glm::cross(right, towardEye));
    const dvec2 sizeMetres = patch.sizePx * metresPerPixelAt(distance, camera, size);
    scene::Object object;
    object.name = material.name;
    object.mesh = std::make_shared<scene::Mesh>(scene::makeQuad(sizeMetres));
    object.partMaterials = {static_cast<std::uint32_t>(board.materials.size())};
    object.castsShadow = false;
    object.source = {.shape = "quad " + scene::numberText(sizeMetres.x) + " " + scene::numberText(sizeMetres.y),
                     .mesh = {},
                     .node = {},
                     .material = material.name,
                     .normals = {},
                     .rotateDegrees = anglesDegrees(worldFromQuad),
                     .translateWorld = camera.positionWorld + worldFromView * placeAt(distance, patch.centrePx, camera, size)};
    object.worldFromObject = scene::worldFromObjectOf(object.source);
    board.materials.push_back(std::move(material));
    board.objects.push_back(std::move(object));
}

} // namespace

std::vector<BoardPatch> BoardLayout::all() const {
    std::vector<BoardPatch> patches(squares.begin(), squares.end());
    patches.insert(patches.end(), wedge.begin(), wedge.end());
    patches.insert(patches.end(), channels.begin(), channels.end());
    return patches;
}

BoardLayout boardLayout(ivec2 size) {
    const int least = std::min(size.x, size.y);
    if (least < kLeastBoardSide)
        throw Error(ExitStatus::badInput, "calibration: a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                                              " pixels is too small for the calibration board; use at least " +
                                              std::to_string(kLeastBoardSide) + " pixels on each side");
    const dvec2 whole(size);
    BoardLayout board;
    // The largest that leave the corners, the wedge and the small squares free; steps of a fifth are seen at a glance.
    constexpr std::array kSides{0.18, 0.15, 0.12, 0.1};
    constexpr double kSmallSide = 0.06; // four pixels of the smallest picture
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec2 corner(i % 2 == 0 ? -1 : 1, i < 2 ? -1 : 1);
        const bool isFar = i == 1 || i == 2;
        board.squares[i] = {0.5 * whole + corner * dvec2(0.34, 0.32) * whole, dvec2(kSides[i] * least), kTurnedDegrees, dvec3(1.0), isFar};
        // Whole in a picture that shows half of the view.
        board.squares[i + 4] = {0.5 * whole + corner * dvec2(0.2, 0.16) * whole, dvec2(kSmallSide * least), kTurnedDegrees, dvec3(1.0), !isFar};
    }
    const auto between = [](double left, double right, double top, double bottom, const dvec3& radiance) {
        const dvec2 from = glm::round(dvec2(left, top)), to = glm::max(glm::round(dvec2(right, bottom)), from + 1.0);
        return BoardPatch{0.5 * (from + to), to - from, 0, radiance};
    };
    const double left = 0.25 * whole.x, step = 0.5 * whole.x / kWedge.size();
    for (std::size_t i = 0; i < kWedge.size(); ++i)
        board.wedge[i] = between(left + step * i, left + step * (i + 1), 0.42 * whole.y, 0.58 * whole.y, dvec3(kWedge[i]));
    for (std::size_t i = 0; i < 3; ++i) {
        const double start = (0.38 + 0.08 * static_cast<double>(i)) * whole.x;
        board.channels[i] = between(start, start + 0.08 * whole.x, 0.66 * whole.y, 0.76 * whole.y,
                                    {kChannelPatches[i][0], kChannelPatches[i][1], kChannelPatches[i][2]});
    }
    const double codeLeft = 0.3 * whole.x, codeTop = 0.79 * whole.y;
    constexpr int kColumns = 8; // the cells are three pixels wide in the smallest picture
    const dvec2 cell = dvec2(0.4, 0.17) * whole / dvec2(kColumns, 2.0 * kCodeBits / kColumns);
    for (int bit = 0; bit < kCodeBits; ++bit)
        for (int row = 0; row < 2; ++row) {
            const double x = codeLeft + bit % kColumns * cell.x, y = codeTop + (bit / kColumns * 2 + row) * cell.y;
            board.code[static_cast<std::size_t>(bit)][static_cast<std::size_t>(row)] = between(x, x + cell.x, y, y + cell.y, dvec3(1.0));
        }
    return board;
}

dvec3 placeInView(const BoardPatch& patch, const scene::Camera& camera, ivec2 size) {
    return placeAt(distanceOf(camera, patch.isFar), patch.centrePx, camera, size);
}

scene::Scene calibrationBoard(const scene::Camera& camera, ivec2 size) {
    const BoardLayout layout = boardLayout(size);
    scene::Scene board;
    board.name = "calibration";
    board.camera = camera;
    std::vector<BoardPatch> patches = layout.all();
    const unsigned code = cameraCode(camera, size);
    for (std::size_t bit = 0; bit < layout.code.size(); ++bit)
        patches.push_back(layout.code[bit][code >> bit & 1 ? 0 : 1]);
    for (const BoardPatch& patch : patches)
        addPatch(board, patch, distanceOf(camera, patch.isFar), camera, size);
    // Black behind all of it, whatever a program's background is: four times the view, for cameras that see more than they should.
    const double farthest = distanceOf(camera, true);
    addPatch(board, {0.5 * dvec2(size), 4.0 * dvec2(size)}, std::min(1.1 * farthest, 0.5 * (farthest + camera.far)), camera, size);
    return board;
}

} // namespace shadowlab::foreign
