// Reads a lesson with the readers of the scene file: the same keys, the same ranges, the same words.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/session/capture_words.h"
#include "app/session/lesson.h"
#include "app/session/lesson_quantities.h"
#include "app/session/light_changes.h"
#include "app/session/settings.h"
#include "techniques/foundation/nearest_names.h"
#include "techniques/foundation/scene/message_text.h"
#include "techniques/foundation/scene/scene_json.h"

namespace shadowlab::session {

namespace {

using scene::JsonDocument;
using scene::JsonObject;
using scene::JsonValue;
using scene::Range;

// What fits below a picture in type that is read from the last row.
constexpr std::size_t kLongestTitle = 60, kLongestSentence = 260, kLongestLabel = 40;
constexpr int kSmallestSide = 16, kLargestSide = 2048; ///< of measured pictures, pixels
constexpr int kMostLessonFrames = 1000;

/// What is said elsewhere about an option of the command line, said about the place in the file.
template <typename Do>
auto saidAt(const JsonDocument& document, std::size_t offset, const Do& what) {
    try {
        return what();
    } catch (const Error& error) {
        std::string message = error.what();
        if (message.starts_with("--set: ")) message.erase(0, 7);
        document.fail(offset, message);
    }
}

std::string shortText(const JsonObject& object, std::string_view key, std::size_t longest) {
    std::string text = object.text(key);
    if (text.empty()) object.fail(key, "is empty; write it, or leave the lesson out");
    if (text.size() > longest)
        object.fail(key, "has " + std::to_string(text.size()) + " characters, and " + std::to_string(longest) +
                             " fit below a picture; make it shorter");
    return text;
}

std::vector<std::pair<std::string, std::size_t>> texts(const JsonObject& object, std::string_view key) {
    std::vector<std::pair<std::string, std::size_t>> texts;
    for (const JsonValue& value : object.array(key)) {
        if (value.kind != JsonValue::Kind::string)
            object.document().fail(value.offset, "each of \"" + std::string(key) + "\" is a text, and this is " +
                                                     std::string(scene::describe(value.kind)) + "; put it in quotes");
        texts.emplace_back(value.string, value.offset);
    }
    return texts;
}

int oneOf(const JsonObject& object, std::string_view key, const std::string& text,
          const std::vector<std::string>& known) {
    const auto found = std::ranges::find(known, text);
    if (found == known.end()) object.fail(key, "is " + scene::inQuotes(text) + "; " + suggestion(text, known));
    return static_cast<int>(found - known.begin());
}

/// Reads one lesson. The parts that both states share are at the top of the file, their own ones in "before" and "after".
class LessonReader {
public:
    LessonReader(const std::string& text, const std::filesystem::path& file)
        : file_(file), document_(text, file, scene::Limits{}.jsonDepth, "a lesson, starting with {"),
          top_(document_, document_.root(), "the lesson",
               {"title", "order", "scene", "camera", "lights", "motion", "layout", "light", "slots", "set", "size",
                "before", "after", "happens", "mends", "look", "expect", "question"}) {}

    [[nodiscard]] LessonText words() const {
        return {file_.stem().string(), file_, shortText(top_, "title", kLongestTitle),
                shortText(top_, "happens", kLongestSentence), shortText(top_, "mends", kLongestSentence)};
    }
    [[nodiscard]] int order() const { return top_.integer("order", 0, 1000, 1000); }

    Lesson read(const scene::LoadOptions& options) {
        Lesson lesson;
        lesson.text = words();
        static_cast<void>(order());
        readSize(lesson);
        lesson.states[0] = state("before", options);
        lesson.states[1] = state("after", options);
        readMotion(lesson);
        readLook(lesson);
        readExpectations(lesson);
        readQuestion(lesson);
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

    LessonState state(const char* name, const scene::LoadOptions& options) {
        const JsonObject own(document_, top_.require(name, R"({"set": ["shadow-map.bias-mode=none"]})"),
                             "\"" + std::string(name) + "\"",
                             {"scene", "camera", "lights", "layout", "slots", "stage", "set"});
        LessonState state;
        loadScene(own.find("scene") ? own : top_, options, state);
        state.camera = state.scene->camera;
        std::vector<scene::Light> lights = state.scene->lights;
        for (const JsonObject* object : {&std::as_const(top_), &own}) {
            if (const JsonValue* camera = object->find("camera"))
                state.camera = scene::readCamera(scene::NumberRanges{}, document_, *camera,
                                                 "the camera of " + object->what(), state.camera);
            readLightChanges(*object, lights);
        }
        state.scene = scene::withLights(state.scene, lights);
        state.light = light(*state.scene);
        readSlots(own.find("slots") ? own : top_, own, state);
        const JsonObject& layoutOf = own.find("layout") ? own : top_;
        std::vector<std::string> layouts;
        for (const Layout layout : {Layout::single, Layout::side, Layout::split, Layout::grid, Layout::diff})
            layouts.emplace_back(layoutName(layout));
        state.layout = static_cast<Layout>(
            oneOf(layoutOf, "layout", layoutOf.text("layout", state.slots.size() == 1 ? "single" : "side"), layouts));
        const int shown = state.layout == Layout::grid ? kPanes : shownPanes(state.layout);
        if (static_cast<int>(state.slots.size()) != shown)
            layoutOf.fail("layout", "shows " + scene::counted(static_cast<std::uint64_t>(shown), "technique") +
                                        ", and " + std::to_string(state.slots.size()) +
                                        " are under \"slots\"; write as many");
        readSettings(own, state);
        return state;
    }

    void loadScene(const JsonObject& object, const scene::LoadOptions& options, LessonState& state) {
        const std::string reference = object.text("scene");
        const std::string ending = std::filesystem::path(reference).extension().string();
        state.sceneName = reference;
        if (ending == ".json" || ending == ".obj") {
            const auto found = scene::AllowedFolders(file_, options).resolve(reference);
            if (!found) object.fail("scene", scene::inQuotes(reference) + " " + std::string(scene::kOutsideMessage));
            state.sceneName = (file_.parent_path() / reference).string();
        } else {
            oneOf(object, "scene", reference, scene::builtInScenes(options.assetsRoot));
        }
        if (loaded_.first != state.sceneName) loaded_ = {state.sceneName, scene::loadScene(state.sceneName, options)};
        state.scene = loaded_.second;
    }

    [[nodiscard]] int light(const scene::Scene& scene) const {
        if (!top_.find("light")) return 0;
        std::vector<std::string> names;
        for (const scene::Light& light : scene.lights)
            names.push_back(light.name);
        return oneOf(top_, "light", top_.text("light"), names);
    }

    void readSlots(const JsonObject& object, const JsonObject& own, LessonState& state) {
        for (const JsonValue& value : object.array("slots")) {
            const JsonObject slot(document_, value, "slot " + std::to_string(state.slots.size() + 1),
                                  {"technique", "stage"});
            PaneState pane;
            pane.technique = slot.text("technique");
            pane.stage = slot.text("stage", "");
            const TechniqueInfo& info = saidAt(document_, slot.require("technique", "\"shadow-map\"").offset,
                                               [&]() -> const TechniqueInfo& { return findTechnique(pane.technique); });
            // The state's own stage is that of all slots.
            const JsonObject& stageOf = own.find("stage") ? own : slot;
            if (own.find("stage")) pane.stage = own.text("stage");
            if (!pane.stage.empty())
                saidAt(document_, stageOf.require("stage", "").offset,
                       [&] { return parseStage(pane.stage, info, *state.scene, state.light); });
            state.slots.push_back(std::move(pane));
        }
        if (state.slots.empty())
            object.fail("slots", R"(is missing or empty; write for example [{"technique": "shadow-map"}])");
        if (state.slots.size() > kPanes)
            object.fail("slots", "has more techniques than the " + std::to_string(kPanes) +
                                     " that the window shows; leave some out");
    }

    /// Settings are checked by slots like those of a capture, and written down as the panes keep them.
    void readSettings(const JsonObject& own, LessonState& state) {
        std::vector<Slot> slots = slotsOf(state.slots);
        for (const JsonObject* object : {&std::as_const(top_), &own})
            for (const auto& [setting, offset] : texts(*object, "set")) {
                saidAt(document_, offset, [&] {
                    applySettings(slots, {setting});
                    return 0;
                });
                if (object == &own) state.settings.push_back(setting);
            }
        for (std::size_t i = 0; i < slots.size(); ++i)
            state.slots[i].settings = settingsOf(slots[i]);
    }

    static std::map<std::string, Values> settingsOf(const Slot& slot) {
        std::map<std::string, Values> settings;
        for (const params::Param& param : slot.params)
            if (params::valueText(param) != params::initialText(param))
                settings[std::string(slot.info->id)][param.id] = params::valueText(param);
        return settings;
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

    void readLook(Lesson& lesson) const {
        for (const JsonValue& value : top_.array("look")) {
            const JsonObject look(document_, value, "box " + std::to_string(lesson.look.size() + 1), {"box", "label"});
            const JsonValue& numbers = look.require("box", "[0.4, 0.4, 0.2, 0.2]");
            const std::string mend = "is not four numbers; write [left, top, width, height] in shares of the picture, "
                                     "as [0.4, 0.4, 0.2, 0.2]";
            if (numbers.kind != JsonValue::Kind::array || numbers.items.size() != 4) look.fail("box", mend);
            std::array<double, 4> box{};
            for (std::size_t i = 0; i < box.size(); ++i) {
                if (numbers.items[i].kind != JsonValue::Kind::number) look.fail("box", mend);
                box[i] = numbers.items[i].number;
            }
            const bool inside =
                box[0] >= 0 && box[1] >= 0 && box[2] > 0 && box[3] > 0 && box[0] + box[2] <= 1 && box[1] + box[3] <= 1;
            if (!inside)
                look.fail("box", "reaches beyond the picture, or is empty; its numbers are shares, from 0 to 1");
            lesson.look.push_back({{box[0], box[1]}, {box[2], box[3]}, shortText(look, "label", kLongestLabel)});
        }
        if (lesson.look.empty()) top_.fail("look", R"(is missing or empty; write [{"box": [...], "label": "..."}])");
    }

    static Bound bound(const JsonObject& expectation, const char* state) {
        const JsonObject keys(expectation.document(), expectation.require(state, R"({"atLeast": 500})"),
                              "\"" + std::string(state) + "\" of " + expectation.what(), {"atLeast", "atMost"});
        Bound bound;
        if (keys.find("atLeast")) bound.atLeast = keys.number("atLeast", Range{});
        if (keys.find("atMost")) bound.atMost = keys.number("atMost", Range{});
        if (!bound.atLeast && !bound.atMost)
            expectation.fail(state, R"(has no bound; write {"atLeast": NUMBER} or {"atMost": NUMBER})");
        return bound;
    }

    void readExpectations(Lesson& lesson) {
        std::vector<std::string> known;
        for (const LessonQuantity& quantity : lessonQuantities())
            known.emplace_back(quantity.id);
        for (const JsonValue& value : top_.array("expect")) {
            const JsonObject keys(document_, value, "expectation " + std::to_string(lesson.expectations.size() + 1),
                                  {"quantity", "slot", "look", "reference", "label", "pixel", "before", "after"});
            Expectation expected;
            expected.quantity = keys.text("quantity");
            const LessonQuantity& quantity =
                kLessonQuantities[static_cast<std::size_t>(oneOf(keys, "quantity", expected.quantity, known))];
            const auto slots = static_cast<int>(std::min(lesson.states[0].slots.size(), lesson.states[1].slots.size()));
            expected.slot = keys.integer("slot", 1, slots, 1) - 1;
            if (keys.find("look"))
                expected.look = keys.integer("look", 1, std::max(1, static_cast<int>(lesson.look.size()))) - 1;
            const bool isFact = quantity.of == LessonQuantity::Of::fact;
            if (isFact) expected.fact = keys.text("label");
            if (keys.find("pixel")) expected.pixel = keys.pair("pixel", Range::between(0, 1));
            if (quantity.of == LessonQuantity::Of::reference) expected.reference = reference(keys);
            if (quantity.of == LessonQuantity::Of::motion && lesson.motion.frames == 1)
                keys.fail("quantity", "is about several frames; write a \"motion\"");
            if (expected.quantity == "crawl" && lesson.motion.orbitLightDegrees)
                keys.fail("quantity", "is about an eye that moves alone; leave out orbitLightDegrees");
            for (const char* key : {"reference", "label", "pixel"})
                if (keys.find(key) && (std::string_view(key) == "reference" ? !expected.reference : !isFact))
                    keys.fail(key, "has nothing to do with " + scene::inQuotes(expected.quantity) + "; leave it out");
            expected.before = bound(keys, "before");
            expected.after = bound(keys, "after");
            lesson.expectations.push_back(std::move(expected));
        }
        if (lesson.expectations.empty())
            top_.fail("expect", "is missing or empty; write what can be measured of the artefact");
    }

    PaneState reference(const JsonObject& keys) {
        const JsonObject object(document_, keys.require("reference", R"({"technique": "ray-traced"})"),
                                "the reference of " + keys.what(), {"technique", "set"});
        PaneState pane;
        pane.technique = object.text("technique");
        saidAt(document_, object.require("technique", "").offset,
               [&]() -> const TechniqueInfo& { return findTechnique(pane.technique); });
        std::vector<Slot> slots = slotsOf({pane});
        for (const auto& [setting, offset] : texts(object, "set"))
            saidAt(document_, offset, [&] {
                applySettings(slots, {setting});
                return 0;
            });
        pane.settings = settingsOf(slots[0]);
        return pane;
    }

    void readQuestion(Lesson& lesson) const {
        const JsonValue* value = top_.find("question");
        if (!value) return;
        const JsonObject keys(document_, *value, "the question", {"text", "kind", "choices", "right"});
        Question question;
        question.text = shortText(keys, "text", kLongestSentence);
        question.kind =
            static_cast<Question::Kind>(oneOf(keys, "kind", keys.text("kind", "choice"), {"choice", "mark"}));
        for (const auto& [choice, offset] : texts(keys, "choices"))
            question.choices.push_back(choice);
        if (question.kind == Question::Kind::mark) {
            for (const char* key : {"choices", "right"})
                if (keys.find(key)) keys.fail(key, "is there for \"kind\": \"choice\"; leave it out");
        } else {
            constexpr int kMostChoices = 4;
            const auto count = static_cast<int>(question.choices.size());
            if (count < 2 || count > kMostChoices) keys.fail("choices", "are two to four; write as many");
            question.right = keys.integer("right", 1, count) - 1;
        }
        lesson.question = std::move(question);
    }

    const std::filesystem::path& file_;
    JsonDocument document_;
    JsonObject top_;
    std::pair<std::string, scene::Snapshot> loaded_; ///< the scene that was loaded last, and its name
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
    return parseLesson(scene::readFile(file, scene::Limits{}.sceneFileBytes), file, options);
}

std::vector<LessonText> builtInLessons(const std::filesystem::path& assetsRoot) {
    std::vector<std::pair<int, LessonText>> found;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(assetsRoot / "lessons", ignored)) {
        if (entry.path().extension() != ".json") continue;
        const std::filesystem::path file = entry.path();
        const LessonReader reader(scene::readFile(file, scene::Limits{}.sceneFileBytes), file);
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

} // namespace shadowlab::session
