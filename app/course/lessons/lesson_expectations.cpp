// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/course/lessons/lesson_parts.h"
#include "app/course/lessons/lesson_quantities.h"
#include "app/lab/old_spelling.h"
#include "app/lab/settings.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

using scene::JsonObject;
using scene::JsonValue;
using scene::Range;

Bound bound(const JsonObject& expectation, const char* state) {
    const JsonObject keys(expectation.document(), expectation.require(state, R"({"atLeast": 500})"),
                          "\"" + std::string(state) + "\" of " + expectation.what(), {"atLeast", "atMost"});
    Bound bound;
    if (keys.find("atLeast")) bound.atLeast = keys.number("atLeast", Range{});
    if (keys.find("atMost")) bound.atMost = keys.number("atMost", Range{});
    if (!bound.atLeast && !bound.atMost)
        expectation.fail(state, R"(has no bound; write {"atLeast": NUMBER} or {"atMost": NUMBER})");
    return bound;
}

lab::PaneState reference(const JsonObject& keys) {
    const JsonObject object(keys.document(), keys.require("reference", R"({"technique": "ray-traced"})"),
                            "the reference of " + keys.what(), {"technique", "set"});
    lab::PaneState pane;
    std::vector<std::string> settings;
    for (const auto& [setting, offset] : texts(object, "set"))
        settings.push_back(setting);
    const lab::OldSpelling spelling({object.text("technique")}, {}, settings);
    pane.technique = spelling.techniques().front();
    saidAt(keys.document(), object.require("technique", "").offset,
           [&]() -> const TechniqueInfo& { return findTechnique(pane.technique); });
    std::vector<picture::Slot> slots = slotsOf({pane});
    for (const auto& [setting, offset] : texts(object, "set"))
        saidAt(keys.document(), offset, [&] {
            lab::applySettings(slots, spelling.today(setting));
            return 0;
        });
    pane.settings = settingsOf(slots[0]);
    return pane;
}

} // namespace

void readExpectations(const JsonObject& top, Lesson& lesson) {
    std::vector<std::string> known;
    for (const LessonQuantity& quantity : lessonQuantities())
        known.emplace_back(quantity.id);
    for (const JsonValue& value : top.array("expect")) {
        const JsonObject keys(top.document(), value, "expectation " + std::to_string(lesson.expectations.size() + 1),
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
    const auto shows = [](const Expectation& e) { return !e.before.meets(e.after); };
    if (!lesson.expectations.empty() && std::ranges::none_of(lesson.expectations, shows))
        top.fail("expect", "allows the same numbers before and after: nothing has to change; write bounds of which one "
                           "begins where the other has ended");
    if (lesson.expectations.empty())
        top.fail("expect", "is missing or empty; write what can be measured of the artefact");
}

const LessonQuantity& quantityOf(const Expectation& expected) {
    return *std::ranges::find(kLessonQuantities, expected.quantity, &LessonQuantity::id);
}

} // namespace shadowlab::course
