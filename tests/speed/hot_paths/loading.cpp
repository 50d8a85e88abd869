// Reading files: a mesh by its triangles, a scene by its objects. Both look at every byte once and find vertices and names in hash
// tables: linear.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "techniques/foundation/scene/load/load.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

/// A file in the system's folder for such, gone when this is.
class ShortLivedFile {
public:
    explicit ShortLivedFile(const std::string& text)
        : path_(std::filesystem::temp_directory_path() / ("benchmark-" + std::to_string(getpid()) + ".obj")) {
        std::ofstream(path_) << text;
    }
    ~ShortLivedFile() { std::filesystem::remove(path_); }
    ShortLivedFile(const ShortLivedFile&) = delete;
    ShortLivedFile& operator=(const ShortLivedFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string objText(const scene::Mesh& mesh) {
    std::string text;
    for (const vec3& p : mesh.positionsMesh)
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (const uvec3& t : mesh.triangles)
        text += "f " + std::to_string(t.x + 1) + " " + std::to_string(t.y + 1) + " " + std::to_string(t.z + 1) + "\n";
    return text;
}

/// Checked line by line, and with smooth normals.
void meshFile(benchmark::State& state) {
    const scene::Mesh mesh = speed::knot(state.range(0));
    const std::string text = objText(mesh);
    const ShortLivedFile file(text);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            scene::loadObj(file.path(), scene::NormalMode::smooth, {.assetsRoot = {}, .allowed = {}, .limits = {}}));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.SetComplexityN(static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK(meshFile)
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 16)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

/// Boxes of different sizes, so that no two share a mesh.
void sceneFile(benchmark::State& state) {
    std::string text = R"({"camera":{"position":[0,3,6],"target":[0,0,0]},)"
                       R"("lights":[{"type":"point","position":[1,5,2]}],"objects":[)";
    for (std::int64_t i = 0; i < state.range(0); ++i)
        text += (i > 0 ? "," : "") + std::string(R"({"shape":"box","size":[1,1,)") + std::to_string(i + 1) +
                R"(],"translate":[)" + std::to_string(2 * i) + ",0,0]}";
    text += "]}";
    for (auto _ : state)
        benchmark::DoNotOptimize(
            scene::parseSceneJson(text, "benchmark.json", {.assetsRoot = {}, .allowed = {}, .limits = {}}));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(sceneFile)
    ->RangeMultiplier(4)
    ->Range(1 << 4, 1 << 12)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
