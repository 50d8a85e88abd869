// `shadowlab export`: a scene in a form that another renderer reads, with what is needed to judge its pictures.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/foreign/export/export_scene.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/load/scene_file.h"

namespace shadowlab::cli {

namespace {

struct ExportOptions {
    std::string scene, view;
    std::filesystem::path output; ///< the folder to be made
    const foreign::Format* format = nullptr;
    ivec2 size{640, 360};
    std::filesystem::path threeModule;
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

void describeExport(DescribedOptions& add) {
    describeScene(add);
    add.option("-o,--output", "DIR", "the folder to be made; it is not there yet");
    add.option("--to", "FORMAT", "gltf, three (a page), mitsuba, pov (POV-Ray) or blender (a script)");
    add.option("--size", "WxH", "pixels of the pictures that the calibration board and the commands are for (default 640x360)");
    add.option("--three-module", "FILE", "with --to three: three.module.js of three.js, to be put into the page");
    describeView(add);
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer("Writes the scene (triangles, materials, lights, camera), a calibration board for the same camera, and a README.md\n"
               "that says how a picture is made that `shadowlab judge` understands, and what the format does not say.\n"
               "Examples:\n"
               "  shadowlab export still-life -o still-life-pov --to pov\n"
               "  shadowlab export still-life -o page --to three --three-module node_modules/three/build/three.module.js");
}

ExportOptions exportOptions(const GivenOptions& given) {
    const std::string example = "shadowlab export SCENE -o DIR --to blender";
    ExportOptions options;
    options.scene = given.required("SCENE", example);
    options.output = given.required("--output", example);
    options.format = &foreign::formatNamed(given.required("--to", example));
    options.size = sizeFrom("--size", given.text("--size", "640x360"), "picture-side");
    options.threeModule = given.text("--three-module");
    if (!options.threeModule.empty() && options.format != &foreign::kThree)
        refuseUsage("--three-module belongs to --to three, not to --to " + std::string(options.format->name) + "; leave it out");
    options.view = given.text("--view");
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    return options;
}

/// Where files are named: as the caller has them, or whole, so that a command runs from any folder.
enum class Paths { asGiven, absolute };

std::string pathWord(const std::filesystem::path& path, Paths paths) {
    return foreign::shellWord((paths == Paths::absolute ? std::filesystem::absolute(path).lexically_normal() : path).string());
}

/// The scene as any command takes it, with the options that go with it.
std::string sceneWords(const ExportOptions& options, Paths paths) {
    const bool isFile = scene::fileKind(options.scene) != scene::FileKind::none; // else built in
    std::string words = isFile ? pathWord(options.scene, paths) : foreign::shellWord(options.scene);
    if (!options.view.empty()) words += " --view " + foreign::shellWord(options.view);
    if (options.normals) words += " --normals " + std::string(scene::kNormalModes[static_cast<std::size_t>(*options.normals)]);
    for (const std::filesystem::path& folder : options.allowed)
        words += " --allow " + pathWord(folder, paths);
    return words;
}

/// The command line that makes the same folder again.
std::string commandText(const ExportOptions& options) {
    std::string text = "shadowlab export " + sceneWords(options, Paths::asGiven) + " -o " + foreign::shellWord(options.output.string()) + " --to " +
                       std::string(options.format->name) + " --size " + std::to_string(options.size.x) + "x" + std::to_string(options.size.y);
    if (!options.threeModule.empty()) text += " --three-module " + foreign::shellWord(options.threeModule.string());
    return text;
}

int exportTo(const ExportOptions& options) {
    const scene::Snapshot scene = loadSeenFrom(options.scene, options.view, loadOptions(options.allowed, options.normals));
    image::writeFolder(options.output, [&](const std::filesystem::path& folder) {
        foreign::exportScene(*scene, {options.format, sceneWords(options, Paths::absolute), commandText(options), options.size, options.threeModule}, folder);
    });
    for (const std::string& remark : scene->notes)
        note(remark);
    print("Written: " + options.output.string() + " for " + std::string(options.format->program) + "; README.md in it says how to go on\n");
    return 0;
}

Work exportWork(const GivenOptions& given) {
    return [options = exportOptions(given)] { return exportTo(options); };
}

} // namespace

const Command kExport{"export", "SCENE", "A scene for another renderer, whose picture can then be judged", describeExport, exportWork};

} // namespace shadowlab::cli
