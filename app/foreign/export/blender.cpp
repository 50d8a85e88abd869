// For Blender: a script that builds the scene and draws it with Cycles (assets/foreign/blender.py.in).
// SPDX-License-Identifier: MIT
#include "app/foreign/export/format.h"
#include "app/foreign/export/left_out.h"
#include "app/foreign/export/light_words.h"
#include "app/foreign/export/plain_scene_json.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::foreign {

namespace {

void writeBlender(const ExportJob& job) {
    std::string script = templateText("blender.py.in");
    script = filledIn(std::move(script), "FILE", job.stem + ".py");
    script = filledIn(std::move(script), "SIZE", std::to_string(job.size.x) + "x" + std::to_string(job.size.y));
    // The scene last: its names may hold any characters.
    script = filledIn(std::move(script), "SCENE", plainSceneJson(job.scene, job.size, ImagesAs::files));
    writeImages(job);
    image::writeWhole(job.folder / (job.stem + ".py"), script);
}

std::vector<std::string> leftOutOfBlender(const PlainScene& scene) {
    LeftOut list(scene);
    list.noReceivesShadow();
    list.soften("the soft edge of the cone falls off along another curve, and toward the edge Blender's spots are darker; for `visibility` the cone "
                "ends where it ends here");
    list.lights([](const scene::Light& light) { return scene::hasArea(light); },
                "in `look` it shines by its surface, so its shadow has a penumbra, as with `ray-traced` and many samples");
    list.materials(hasHighlight, "the highlight is Beckmann's lobe of the same width, and mirrors things nearby a little");
    list.materials(isBlurred, "rays are spread by GGX, which has longer tails");
    list.materials(isGlass, "refracts at every surface; nested media have no priority");
    return list.take();
}

std::string howToBlender(const PlainScene& scene, ivec2 size) {
    const std::string start = "    blender -b --factory-startup --python-exit-code 3 --python ";
    const std::string pixels = " --size " + std::to_string(size.x) + "x" + std::to_string(size.y);
    std::string text = "With Blender 3.4 or later (tried with 3.4.1; `apt install blender`):\n\n" + start + "scene.py --" + pixels +
                       " -o look.png\n" + start + "calibration.py --" + pixels + " -o calibration.png\n";
    for (const std::string& light : lightWords(scene.lights))
        for (const std::string picture : {"shaded", "unshadowed", "visibility"})
            text += start + "scene.py -- --picture " + picture + " --light " + light + pixels + " -o " + picture + "-" + light + ".png\n";
    return text + "\nPictures are sRGB with 16 bits a channel: view transform Standard, no look, no dithering. All rays of a pixel go through its "
                  "centre, because the filter is a hundredth of a pixel wide. Light is direct: diffuse surfaces send each other nothing. "
                  "`--help` behind `--` lists all options.\n";
}

} // namespace

const Format kBlender{"blender", "Blender (Cycles)", "`scene.py`, `calibration.py`: scripts", "images of materials lie in `textures/`", true, writeBlender,
                      leftOutOfBlender, howToBlender};

} // namespace shadowlab::foreign
