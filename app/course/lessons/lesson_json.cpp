// Reads a lesson with the readers of the scene file: the same keys, the same ranges, the same words.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/course/lessons/lesson_parts.h"
#include "app/course/state_json.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

using scene::JsonDocument;
using scene::JsonObject;
using scene::JsonValue;
using scene::Range;

constexpr int kSmallestSide = 16, kLargestSide = 2048; ///< of measured pictures, pixels
constexpr int kMostLessonFrames = 1000;

class LessonReader {
public:
    LessonReader(const std::string& text, const std::filesystem::path& file)
        : file_(file), document_(text, file, picture::limits().jsonDepth, "a lesson, starting with {"),
          top_(document_, document_.root(), "the lesson",
               {"title", "chapter", "order", "scene", "camera", "lights", "motion", "layout", "light", "slots", "set", "size",
                "before", "after", "happens", "mends", "look", "expect", "question", "alike"}) {}

    [[nodiscard]] LessonText words() const {
        std::vector<std::string> alike;
        for (const auto& [name, offset] : texts(top_, "alike"))
            alike.push_back(name);
        return {.name = file_.stem().string(),
                .file = file_,
                .title = shortText(top_, "title", kLongestTitle),
                .chapter = top_.find("chapter") ? shortText(top_, "chapter", kLongestLabel) : std::string(),
                .happens = shortText(top_, "happens", kLongestSentence),
                .remedy = shortText(top_, "mends", kLongestSentence),
                .alike = std::move(alike)};
    }
    [[nodiscard]] int order() const { return top_.integer("order", 0, 1000, 1000); }

    Lesson read(const scene::LoadOptions& options) {
        Lesson lesson;
        lesson.text = words();
        static_cast<void>(order());
        readSize(lesson);
        StateReader reader(document_, file_, options);
        lesson.states[0] = state(reader, "before");
        lesson.states[1] = state(reader, "after");
        readMotion(lesson);
        readLook(top_, lesson);
        readExpectations(top_, lesson);
        readQuestion(top_, lesson);
        return lesson;
    }

private:
    void readSize(Lesson& lesson) const {
        if (!top_.find("size")) return;
        const dvec2 size = top_.pair("size", Range::between(kSmallestSide, kLargestSide));
        lesson.size = ivec2(size);
        if (dvec2(lesson.size) != size)
            top_.fail("size", "is pixels, and these are whole; write for example [320, 180]");
    }

    /// What both states share stands at the top of the file, what is a state's own in its object.
    ShownState state(StateReader& reader, const char* name) const {
        const JsonObject own(document_, top_.require(name, R"({"set": ["shadow-map.bias-mode=none"]})"),
                             "\"" + std::string(name) + "\"",
                             {"scene", "camera", "lights", "layout", "slots", "stage", "step", "split", "set"});
        const std::array levels{&top_, &own};
        return reader.read(levels);
    }

    void readMotion(Lesson& lesson) const {
        const JsonValue* value = top_.find("motion");
        if (!value) return;
        const JsonObject motion(document_, *value, "the motion", {"frames", "orbitLightDegrees", "orbitCameraDegrees"});
        lesson.motion.frames = motion.integer("frames", 2, kMostLessonFrames);
        const Range turn = Range::between(-3600, 3600);
        if (motion.find("orbitLightDegrees"))
            lesson.motion.orbitLightDegrees = motion.number("orbitLightDegrees", turn);
        if (motion.find("orbitCameraDegrees"))
            lesson.motion.orbitCameraDegrees = motion.number("orbitCameraDegrees", turn);
        if (!lesson.motion.orbitLightDegrees && !lesson.motion.orbitCameraDegrees)
            motion.fail("frames", "are all alike; write orbitLightDegrees or orbitCameraDegrees");
    }

    const std::filesystem::path& file_;
    JsonDocument document_;
    JsonObject top_;
};

} // namespace

Lesson parseLesson(const std::string& text, const std::filesystem::path& file, const scene::LoadOptions& options) {
    return LessonReader(text, file).read(options);
}

Lesson loadLesson(const std::string& nameOrPath, const scene::LoadOptions& options) {
    std::filesystem::path file(nameOrPath);
    if (file.extension() != ".json") {
        std::vector<std::string> known;
        for (const LessonText& lesson : builtInLessons(options.assetsRoot))
            known.push_back(lesson.name);
        if (std::ranges::find(known, nameOrPath) == known.end())
            throw Error(ExitStatus::badInput, "lesson '" + scene::shown(nameOrPath) +
                                                  "': neither a built-in lesson nor a .json file; " +
                                                  suggestion(nameOrPath, known));
        file = options.assetsRoot / "lessons" / (nameOrPath + ".json");
    }
    const std::string text = scene::readFile(file, picture::limits().sceneFileBytes, "scene-file");
    image::keepInput(file);
    return parseLesson(text, file, options);
}

std::vector<LessonText> builtInLessons(const std::filesystem::path& assets) {
    std::vector<std::pair<int, LessonText>> found;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(assets / "lessons", ignored)) {
        if (entry.path().extension() != ".json") continue;
        const std::filesystem::path file = entry.path();
        const LessonReader reader(scene::readFile(file, picture::limits().sceneFileBytes, "scene-file"), file);
        found.emplace_back(reader.order(), reader.words());
    }
    std::ranges::sort(found, [](const auto& a, const auto& b) {
        return std::tie(a.first, a.second.name) < std::tie(b.first, b.second.name);
    });
    std::vector<LessonText> lessons;
    for (auto& [order, text] : found)
        lessons.push_back(std::move(text));
    return lessons;
}

} // namespace shadowlab::course
