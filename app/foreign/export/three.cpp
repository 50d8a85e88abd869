// For three.js: one page that draws the scene (assets/foreign/three.html.in, three_rays.js), with or without the library in it.
// SPDX-License-Identifier: MIT
#include "app/foreign/export/format.h"
#include "app/foreign/export/left_out.h"
#include "app/foreign/export/light_words.h"
#include "app/foreign/export/plain_scene_json.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::foreign {

namespace {

/// A module as text within the page, from where its own script takes it. In JavaScript "<\/" is "</" in every text and comment.
std::string carried(const std::string& id, std::string module) {
    for (std::size_t at = module.find("</script"); at != std::string::npos; at = module.find("</script", at + 3))
        module.replace(at, 2, "<\\/");
    return "<script type=\"text/plain\" id=\"" + id + "\">" + module + "</script>\n";
}

/// three.module.js, and the file beside it that newer ones import.
std::string modules(const std::filesystem::path& file) {
    constexpr std::uint64_t kMostBytes = 64u << 20; // three.js has two million
    const std::string module = scene::readFile(file, kMostBytes);
    std::string text;
    for (const char* core : {"three.core.js", "three.core.min.js"})
        if (module.find(std::string("./") + core) != std::string::npos) text += carried("three-core", scene::readFile(file.parent_path() / core, kMostBytes));
    if (module.find("WebGLRenderer") == std::string::npos)
        throw Error(ExitStatus::badInput, scene::shown(file.string(), 4096) + ": is no module of three.js; give its build/three.module.js");
    return text + carried("three-module", module);
}

void writeThree(const ExportJob& job) {
    std::string page = templateText("three.html.in");
    page = filledIn(std::move(page), "FILE", job.stem + ".html");
    page = filledIn(std::move(page), "RAYS", templateText("three_rays.js"));
    page = filledIn(std::move(page), "THREE", job.threeModule.empty() ? "" : modules(job.threeModule));
    // The scene last: its names may hold any characters.
    page = filledIn(std::move(page), "SCENE", plainSceneJson(job.scene, job.size, ImagesAs::dataUrls));
    image::writeWhole(job.folder / (job.stem + ".html"), page);
}

std::vector<std::string> leftOutOfThree(const PlainScene& scene) {
    LeftOut list(scene);
    list.add("exact shadows, where `shadows=rays` is not asked for: three.js has shadow maps, of 4096 x 4096 texels for directional lights and spots and "
             "2048 x 2048 for each side of the cube around a point light (`?map=N` sets another number)");
    list.lights([](const scene::Light& light) { return scene::hasArea(light); },
                "is a point at its centre, with a sharp shadow; its strength falls off as that of a point");
    list.lights([](const scene::Light& light) { return light.type == scene::LightType::rect; },
                "without `shadows=rays` it has no cosine at the lamp, and in `look` the sheet that keeps its light to its front shadows other lights as well");
    list.soften("without `shadows=rays` the soft edge of the cone falls off with the cosine; for `visibility` the cone ends where it ends here");
    list.materials(isMirror, "mirrors nothing");
    list.materials(isGlass, "lets nothing through");
    list.materials(hasHighlight, "the highlight grows toward grazing angles (Schlick's Fresnel term)");
    return list.take();
}

constexpr const char* kCanvas = "\nThe canvas is not antialiased: one sample at the centre of each pixel. There is no tone mapping, and colours are sRGB with 8 bits.\n";

std::string howToThree(const PlainScene& scene, ivec2 size) {
    const std::string pixels = std::to_string(size.x) + "x" + std::to_string(size.y);
    std::string text =
        "The page imports three.js (tried with 0.187). Either it carries the library, where `export` was given `--three-module`; then it runs from "
        "anywhere, also from `file://`. Or put `three.module.js` and `three.core.js` (npm: `node_modules/three/build/`) beside it and serve the "
        "folder, because browsers import no modules from `file://`:\n\n"
        "    python3 -m http.server 8000\n\n"
        "Open `scene.html` and `calibration.html` with these addresses, and save the picture by the link below it:\n\n"
        "    scene.html?size=" + pixels + "\n    calibration.html?size=" + pixels + "\n";
    const std::vector<std::string> words = lightWords(scene.lights);
    for (const std::string& light : words)
        for (const char* picture : {"shaded", "unshadowed", "visibility"})
            text += std::string("    scene.html?picture=") + picture + "&light=" + light + "&size=" + pixels + "\n";
    if (!words.empty())
        text += "\nThese have the shadow maps of three.js. With `&shadows=rays` at the end of an address shadows are found by rays, in double precision: one "
                "through the centre of each pixel, and one from the surface that it meets to the light. So no texel decides, and the picture holds against the truth; "
                "it takes some seconds. Surfaces are shaded by three.js either way, and what mirrors or lets light through is not drawn.\n";
    text += "\nIn place of these words the page takes the names of lights as well; other signs than letters and digits are to be percent-encoded in an address.\n";
    if (words.empty()) return text + kCanvas;
    return text + "\nWithout a window, for example with Chromium, the page that is printed holds the picture as a `data:` URL:\n\n"
                  "    chromium --headless --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --virtual-time-budget=60000 --dump-dom \\\n"
                  "        \"file://$PWD/scene.html?picture=visibility&shadows=rays&light=" + words.front() + "&size=" + pixels + "\" | grep -o 'href=\"data:[^\"]*' | cut -d , -f 2 | base64 -d > "
                  "visibility-" + words.front() + ".png\n" +
           kCanvas;
}

} // namespace

const Format kThree{"three", "three.js", "`scene.html`, `calibration.html`: pages", "images of materials included", true, writeThree, leftOutOfThree, howToThree};

} // namespace shadowlab::foreign
