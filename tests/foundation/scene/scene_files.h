// What the loader tests share: a folder that vanishes, and checks on meshes and errors.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

/// A new empty folder, removed with everything in it at the end of the test.
class TempFolder {
public:
    TempFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "shadowlab_test_XXXXXX").string();
        if (!::mkdtemp(pattern.data())) std::abort();
        path_ = std::filesystem::canonical(pattern);
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// The Error that `action` throws; fails the test when it throws none.
template <typename Action>
Error errorOf(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "no error was thrown";
    return {ExitStatus::ok, ""};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Area vectors of all triangles added up: for a flat polygon its area in the direction of its normal, for a closed
/// surface zero.
inline dvec3 areaVectorSum(const Mesh& mesh) {
    dvec3 sum(0.0);
    for (const uvec3& t : mesh.triangles) {
        const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
        sum += 0.5 * glm::cross(b - a, c - a);
    }
    return sum;
}

inline double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const uvec3& t : mesh.triangles) {
        const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
        sum += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return sum;
}

/// Signed volume (divergence theorem): positive when the faces of a closed surface look outward.
inline double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const uvec3& t : mesh.triangles) {
        const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

/// Closed and wound alike: every directed edge, told by the bits of its ends, occurs once, and so does its reverse.
inline bool isClosed(const Mesh& mesh) {
    using Place = std::array<std::uint32_t, 3>;
    const auto place = [&](std::uint32_t i) {
        const vec3 p = mesh.positionsMesh[i];
        return Place{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                     std::bit_cast<std::uint32_t>(p.z)};
    };
    std::map<std::pair<Place, Place>, int> edges;
    for (const uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            ++edges[{place(t[i]), place(t[(i + 1) % 3])}];
    for (const auto& [edge, count] : edges) {
        const auto reverse = edges.find({edge.second, edge.first});
        if (count != 1 || reverse == edges.end() || reverse->second != 1) return false;
    }
    return true;
}

} // namespace shadowlab::scene
