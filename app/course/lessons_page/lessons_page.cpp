// SPDX-License-Identifier: MIT
#include "app/course/lessons_page/lessons_page.h"

#include <cctype>

#include "app/course/lessons/lesson_quantities.h"
#include "app/course/page_code.h"
#include "app/drawing/markup.h"
#include "app/picture/labels.h"
#include "app/picture/verdict_reasons.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

using drawing::escapedMarkup;

constexpr std::array kLessonStyles{"lessons.css"};
constexpr std::array kLessonScripts{"explore_parts.js", "lessons.js"};
constexpr int kDigits = 4; ///< of a number beside its bounds: these have fewer
/// Shares of the height: a name above or below a frame takes no more.
constexpr double kRoomOfLabel = 0.1;

std::string element(const std::string& tag, const std::string& text) { return "<" + tag + ">" + text + "</" + tag.substr(0, tag.find(' ')) + ">"; }

std::string capital(std::string text) {
    if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

/// "A", "B" ...
std::string letter(std::size_t choice) { return {static_cast<char>('A' + choice)}; }

/// Without "(Space)": that key is the window's.
std::string labelOf(const LookBox& box) { return box.label.substr(0, box.label.find(" (")); }

std::string techniqueTitles(const ShownState& state) {
    std::string titles;
    for (const lab::PaneState& slot : state.slots)
        titles += (titles.empty() ? "" : ", ") + std::string(findTechnique(slot.technique).title);
    return titles;
}

/// What is seen, but not what it is called. Where the remedied picture is asked about, what is wrong in the other one is the answer.
std::string alternative(const Lesson& lesson, const LessonChoices& asked, std::size_t state, std::size_t frame) {
    const ShownState& shown = lesson.states[state];
    std::string text = state == asked.picture ? "The picture that is asked about, by " : "The other picture, by ";
    if (asked.picture == 0) text = (state == 0 ? "The picture with the fault, by " : "The same after the remedy, by ");
    text += techniqueTitles(shown);
    if (lesson.states[state].slots.size() > 1) text += ", side by side";
    if (frame > 0) text += ", frame " + std::to_string(frame + 1) + " of " + std::to_string(lesson.motion.frames);
    text += ".";
    if (state > 0 || asked.picture != 0) return text;
    text += " To be seen: ";
    for (std::size_t i = 0; i < lesson.look.size(); ++i)
        text += (i > 0 ? "; " : "") + labelOf(lesson.look[i]);
    return text + ".";
}

std::string pictures(const Lesson& lesson, const PageLesson& page) {
    std::string html;
    for (std::size_t state = 0; state < page.pictures.size(); ++state)
        for (std::size_t frame = 0; frame < page.pictures[state].size(); ++frame)
            html += std::string("<img class=\"") + (state == 0 ? "before" : "after") + (frame == 0 ? "" : " later") + "\" decoding=\"async\" width=\"" +
                    std::to_string(kPagePictureSize.x) + "\" height=\"" + std::to_string(kPagePictureSize.y) + "\" alt=\"" +
                    escapedMarkup(alternative(lesson, page.asked, state, frame)) + "\" src=\"data:image/webp;base64," +
                    drawing::base64(page.pictures[state][frame]) + "\">\n";
    return html;
}

/// The frames of where to look, in shares of the picture. A name stands above its frame, else below, else in it. Its own middle is where
/// the frame's is, moved so that it never leaves the picture.
std::string looks(const Lesson& lesson) {
    const auto percent = [](double share) { return picture::fixed(100 * share, 2) + "%"; };
    std::string html;
    for (const LookBox& box : lesson.look) {
        const dvec2 end = box.corner + box.size;
        html += "<div class=\"look\" style=\"left:" + percent(box.corner.x) + ";top:" + percent(box.corner.y) + ";width:" + percent(box.size.x) +
                ";height:" + percent(box.size.y) + "\"></div>";
        std::string place = "top:" + percent(box.corner.y);
        if (box.corner.y > kRoomOfLabel) place = "bottom:" + percent(1 - box.corner.y);
        else if (end.y < 1 - kRoomOfLabel) place = "top:" + percent(end.y);
        const std::string middle = percent(box.corner.x + box.size.x / 2);
        html += "<div class=\"label\" style=\"left:" + middle + ";transform:translateX(-" + middle + ");" + place + "\">" +
                escapedMarkup(labelOf(box)) + "</div>\n";
    }
    return html;
}

std::string changes(const Lesson& lesson) {
    std::string rows;
    for (const LessonChange& change : changesOf(lesson))
        rows += "<tr>" + element("th scope=\"row\"", escapedMarkup(capital(change.name))) + element("td", escapedMarkup(change.before)) +
                element("td", escapedMarkup(change.after)) + "</tr>\n";
    return "<table class=\"changes\"><caption>What is changed</caption>\n<thead><tr><td></td><th scope=\"col\">before</th><th scope=\"col\">after</th></tr></thead>\n"
           "<tbody>" + rows + "</tbody></table>\n";
}

/// "Dark, but should be lit, in the frame (pixels)"
std::string nameOf(const Lesson& lesson, const Expectation& expected) {
    const LessonQuantity& quantity = quantityOf(expected);
    std::string name = expected.fact.empty() ? std::string(quantity.name) : capital(expected.fact);
    if (lesson.states[0].slots.size() > 1) name += ", picture " + std::to_string(expected.slot + 1);
    if (expected.reference) name += ", " + std::string(findTechnique(expected.reference->technique).title);
    if (expected.look) name += ", in the frame" + (lesson.look.size() > 1 ? " “" + labelOf(lesson.look[static_cast<std::size_t>(*expected.look)]) + "”" : "");
    if (!quantity.unit.empty()) name += " (" + std::string(quantity.unit) + ")";
    return name;
}

std::string numbers(const Lesson& lesson, const PageLesson& page) {
    std::string rows;
    for (std::size_t i = 0; i < page.measured.size(); ++i) {
        const Expectation& expected = lesson.expectations[i];
        rows += "<tr>" + element("th scope=\"row\"", escapedMarkup(nameOf(lesson, expected)));
        for (std::size_t state = 0; state < 2; ++state) {
            const double value = page.measured[i][state];
            const Bound& bound = state == 0 ? expected.before : expected.after;
            rows += "<td><data value=\"" + scene::numberText(value) + "\">" + picture::shortNumber(value, kDigits) + "</data> <small>expected " +
                    bound.text() + (bound.holds(value) ? "" : ", and it is not") + "</small></td>";
        }
        rows += "</tr>\n";
    }
    return "<table class=\"numbers\"><caption>Measured in pictures of " + std::to_string(lesson.size.x) + " × " +
           std::to_string(lesson.size.y) + " pixels</caption>\n"
           "<thead><tr><td></td><th scope=\"col\">before</th><th scope=\"col\">after</th></tr></thead>\n<tbody>" + rows + "</tbody></table>\n";
}

std::string section(const Lesson& lesson, const PageLesson& page, std::size_t number, std::size_t count, const std::string& answer) {
    const std::string id = std::to_string(number);
    const LessonChoices& asked = page.asked;
    std::string html = "<section class=\"lesson" + std::string(asked.picture == 0 ? "" : " asks-after") + "\" id=\"lesson-" + id + "\" data-name=\"" +
                       escapedMarkup(lesson.text.name) + "\" data-right=\"" + std::to_string(asked.right) + "\" aria-labelledby=\"title-" + id + "\">\n" +
                       "<div class=\"head\"><div class=\"words\"><p class=\"chapter\">" + escapedMarkup(lesson.text.chapter) + "<span class=\"by\">Drawn by: " +
                       escapedMarkup(techniqueTitles(lesson.states[asked.picture])) + "</span></p>\n<h2 id=\"title-" + id + "\">Lesson " + id + " of " +
                       std::to_string(count) + "<span class=\"title\">: " + escapedMarkup(lesson.text.title) + "</span></h2></div></div>\n" +
                       "<div class=\"stage\"><div class=\"picture\">\n" + pictures(lesson, page) + looks(lesson) + "</div></div>\n<div class=\"talk\">\n" +
                       element("p class=\"question\"", escapedMarkup(asked.question)) + "\n<ol class=\"choices\" type=\"A\">\n";
    for (const std::string& choice : asked.choices)
        html += element("li", escapedMarkup(choice)) + "\n";
    html += "</ol>\n<details class=\"answer\"><summary>The answer</summary>\n" + element("p class=\"answer-is\"", escapedMarkup(answer)) + "\n" +
            element("p class=\"happens\"", escapedMarkup(lesson.text.happens)) + "\n<div class=\"remedy\">\n<h3>The remedy</h3>\n" +
            element("p class=\"mends\"", escapedMarkup(lesson.text.remedy)) + "\n" + changes(lesson) + numbers(lesson, page) + "</div>\n</details>\n";
    return html + "</div>\n</section>\n";
}

std::string key(const std::vector<PageEntry>& entries) {
    std::string lines;
    for (const PageEntry& entry : entries) {
        const bool namesTitle = entry.answer.ends_with(entry.title);
        lines += element("li", escapedMarkup(entry.answer + (namesTitle ? "" : " (" + entry.title + ")"))) + "\n";
    }
    return "<section id=\"key\"><h2>The answers</h2>\n<ol>\n" + lines + "</ol></section>\n";
}

std::string overview(const std::vector<PageEntry>& entries) {
    std::string html = "<nav id=\"overview\" aria-label=\"All lessons\">\n";
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const bool begins = i == 0 || entries[i].chapter != entries[i - 1].chapter;
        if (begins) html += (i == 0 ? "" : "</ol>\n") + element("h2", escapedMarkup(entries[i].chapter)) + "\n<ol>\n";
        const std::string number = std::to_string(i + 1);
        html += "<li><a href=\"#lesson-" + number + "\">Lesson " + number + "</a></li>\n";
    }
    return html + "</ol>\n</nav>\n";
}

} // namespace

PageEntry pageEntry(const Lesson& lesson, const PageLesson& page, std::size_t number, std::size_t count) {
    const std::string answer = letter(page.asked.right) + ": " + page.asked.choices[page.asked.right];
    return {lesson.text.chapter, lesson.text.title, answer, section(lesson, page, number, count, answer)};
}

std::string lessonsPage(const std::vector<PageEntry>& entries, const std::filesystem::path& assets) {
    std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Lessons on shadows</title>\n<style>" +
                       pageCode(assets, kLessonStyles) + "</style>\n</head>\n<body>\n<header>\n<h1>Lessons on shadows</h1>\n"
                       "<p class=\"about\">Each lesson shows a picture with a fault, and asks about it. Then it says why it is so, and what mends it.</p>\n</header>\n" +
                       overview(entries) + "<main>\n";
    for (const PageEntry& entry : entries)
        page += entry.section;
    return page + "</main>\n" + key(entries) + "<script>" + pageCode(assets, kLessonScripts) + "</script>\n</body>\n</html>\n";
}

} // namespace shadowlab::course
