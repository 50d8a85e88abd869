// An object that is scaled unevenly, with smooth normals, is shaded as the same mesh written out with that scale.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

/// A ball with three ribs, of few and large faces, whose normals differ much from corner to corner. Its coordinates are
/// multiples of 1/64: times a small whole number they are still exact, in the file's six digits, in float and after scaling.
std::string ribbedBall(int sx, int sy, int sz) {
    constexpr int kRows = 6, kColumns = 10;
    std::string obj;
    const auto exact = [](double value) { return std::round(64 * value) / 64; };
    for (int row = 0; row <= kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const double t = std::numbers::pi * row / kRows, p = 2 * std::numbers::pi * column / kColumns;
            const double radius = 0.5 * (1 + 0.2 * std::sin(3 * p) * std::sin(t));
            obj += "v " + std::to_string(sx * exact(radius * std::sin(t) * std::cos(p))) + " " +
                   std::to_string(sy * exact(radius * std::cos(t))) + " " +
                   std::to_string(sz * exact(radius * std::sin(t) * std::sin(p))) + "\n";
        }
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const int next = (column + 1) % kColumns, above = row * kColumns + 1, below = above + kColumns;
            for (const auto& [a, b, c] : {std::array{above + column, above + next, below + next},
                                          std::array{above + column, below + next, below + column}})
                obj += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
        }
    return obj;
}

class StretchedNormalsTest : public CommandTest {
protected:
    image::Image picture(const std::string& mesh, const std::string& scale, const std::string& technique) const {
        folder.write(
            "s.json",
            R"({"camera": {"position": [2, 2, 4], "target": [0, 0.8, 0]}, "ambient": [0.05, 0.05, 0.05],
  "lights": [{"type": "point", "position": [2, 4, 3], "intensity": 40}],
  "materials": {"m": {"diffuse": [0.7, 0.6, 0.5], "specular": [0.4, 0.4, 0.4], "shininess": 60}},
  "objects": [{"shape": "quad", "size": [8, 8]}, {"mesh": ")" +
                mesh + R"(", "scale": )" + scale +
                R"(, "normals": "smooth", "material": "m", "translate": [0, 1.2, 0], "rotateDegrees": [0, 20, 10]}]})");
        succeed({"capture", "s.json", "-o", "x.png", "--size", "320x240", "-t", technique});
        return decoded(fileContent(folder.path() / "x.png")).image;
    }
};

TEST_F(StretchedNormalsTest, AreThoseOfTheMeshWrittenOut) {
    folder.write("ball.obj", ribbedBall(1, 1, 1));
    folder.write("stretched.obj", ribbedBall(1, 3, 2));
    for (const std::string technique : {"unshadowed", "shadow-map", "ray-traced", "lecture-ray-tracing"}) {
        const image::Image scaled = picture("ball.obj", "[1, 3, 2]", technique);
        const image::Image writtenOut = picture("stretched.obj", "1", technique);
        ASSERT_EQ(scaled.rgba.size(), writtenOut.rgba.size());
        int most = 0;
        for (std::size_t i = 0; i < scaled.rgba.size(); ++i)
            most = std::max(most, std::abs(scaled.rgba[i] - writtenOut.rgba[i]));
        // Normals are rounded to float before the scale here and after it there, 1e-7: a level of 255 where a value lies between
        // two. Interpolated at the lengths that the scale gives them, they differed by 55 levels.
        EXPECT_LE(most, 1) << technique;
    }
}

} // namespace
} // namespace shadowlab::testing
