// `shadowlab pack`: a scene and all the files that it is made of in one folder, which travels.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/context/signals.h"
#include "app/picture/digest.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/pack/pack_scene.h"

namespace shadowlab::cli {

namespace {

struct PackOptions {
    std::string scene;            ///< a .json, a mesh or the name of a built-in scene
    std::filesystem::path output; ///< the folder to be made
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

void describePack(DescribedOptions& add) {
    describeScene(add);
    add.option("-o,--output", "DIR", "the folder to be made; it is not there yet");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer(
        "Writes DIR/NAME.json, meshes and their material files in DIR/meshes, images in textures. All paths are "
        "relative, "
        "so that the folder can be moved, and nothing has to be allowed. The pictures stay the same, to the byte.\n"
        "Examples:\n"
        "  shadowlab pack bunny.obj -o lesson-on-bunnies\n"
        "  shadowlab pack still-life -o my-still-life\n"
        "  shadowlab pack mine.json -o travels");
}

PackOptions packOptions(const GivenOptions& given) {
    const std::string example = "shadowlab pack SCENE -o DIR";
    PackOptions options{given.required("SCENE", example), given.required("--output", example), {}, {}};
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    return options;
}

/// A digest of all that is seen. Materials are taken part by part: their names, their order and those that nothing shows do not
/// matter.
std::string digestOfLook(const scene::Scene& scene) {
    scene::Scene look = scene;
    look.materials.clear();
    for (scene::Object& object : look.objects)
        for (std::uint32_t& material : object.partMaterials) {
            look.materials.push_back(scene.materials[material]);
            look.materials.back().name.clear();
            material = static_cast<std::uint32_t>(look.materials.size() - 1);
        }
    return picture::digestOf(look);
}

int pack(const PackOptions& options) {
    const scene::LoadOptions loading = loadOptions(options.allowed, options.normals);
    const scene::Snapshot scene = scene::loadScene(options.scene, loading);
    scene::PackedScene packed;
    image::writeFolder(options.output, [&](const std::filesystem::path& folder) {
        packed = scene::packScene(options.scene, *scene, loading, folder, context::throwIfInterrupted);
        // It is read as it will be anywhere: from its own folder alone.
        scene::LoadOptions alone = loadOptions({});
        alone.assetsRoot.clear();
        const scene::Snapshot read = scene::loadScene((folder / packed.file).string(), alone);
        context::throwIfInterrupted();
        if (digestOfLook(*read) != digestOfLook(*scene))
            throw Error(ExitStatus::bug,
                        scene::shown(options.scene, 4096) +
                            ": the packed scene is not the same as this one; this is a fault of the program, "
                            "please report it with the scene");
    });
    for (const std::string& remark : scene->notes)
        note(remark);
    print("Written: " + (options.output / packed.file).string() +
          (packed.copies == 0 ? "" : " and " + scene::counted(packed.copies, "file") + " that it is made of") + "\n");
    return 0;
}

Work packWork(const GivenOptions& given) {
    return [options = packOptions(given)] { return pack(options); };
}

} // namespace

const Command kPack{"pack", "SCENE", "A scene and all its files in one folder, which can be taken anywhere",
                    describePack, packWork};

} // namespace shadowlab::cli
