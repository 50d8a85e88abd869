// `shadowlab inspect`: what a mesh or a scene is made of, and what that means for each technique.
// SPDX-License-Identifier: MIT
#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/inspection_json.h"
#include "app/cli/inspection_text.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/text_table.h"

namespace shadowlab::cli {

namespace {

struct InspectOptions {
    std::string file; ///< a mesh, a .json or the name of a built-in scene
    bool json = false;
    std::optional<scene::NormalMode> normals;   ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed; ///< further folders a scene may take meshes from
};

void describeInspect(DescribedOptions& add) {
    add.option("FILE", "", "a mesh (.obj, .gltf, .glb), a .json scene or a built-in name (`list scenes`)");
    add.flag("--json", "one JSON object instead of a table");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer("Examples:\n"
               "  shadowlab inspect still-life\n"
               "  shadowlab inspect bunny.obj --json");
}

InspectOptions inspectOptions(const GivenOptions& given) {
    InspectOptions options{given.required("FILE", "for example shadowlab inspect bunny.obj"), given.has("--json"), {}, {}};
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.file);
    return options;
}

int inspect(const InspectOptions& options) {
    const Inspection inspection = inspectFile(options.file, loadOptions(options.allowed, options.normals));
    print(options.json ? inspectionJson(inspection).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                       : fitting(inspectionText(inspection), terminalColumns()));
    return 0;
}

Work inspectWork(const GivenOptions& given) {
    return [options = inspectOptions(given)] { return inspect(options); };
}

} // namespace

const Command kInspect{"inspect", "FILE", "What a mesh or a scene is made of, and what that means for each technique",
                       describeInspect, inspectWork};

} // namespace shadowlab::cli
