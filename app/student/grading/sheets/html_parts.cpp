// SPDX-License-Identifier: MIT
#include "app/student/grading/sheets/html_parts.h"

#include <cstdint>
#include <span>
#include <string_view>

#include "app/drawing/markup.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::student {

namespace {

std::span<const std::uint8_t> bytesOf(std::string_view text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

/// <img> with the picture in it. `type`: "png", "svg+xml".
std::string imageHtml(std::string_view type, std::span<const std::uint8_t> bytes, std::string_view what) {
    return "<img style=\"max-width:100%\" alt=\"" + drawing::escapedMarkup(what) + "\" src=\"data:image/" + std::string(type) +
           ";base64," + drawing::base64(bytes) + "\">";
}

} // namespace

std::string caseText(const CaseResult& result, const Family& family, const std::vector<Blank>& blanks) {
    if (result.isRight()) return "Right: " + std::to_string(*result.wrong) + " wrong pixels, " + std::to_string(result.which->limit) + " may be.";
    const std::string hint = hintOf(result);
    if (hint.empty()) return whatIsWrong(result, family);
    const std::vector<int> numbers = numbersIn(result.which->blanks);
    std::string tested;
    if (const std::string names = namesOf(numbers, blanks); !names.empty()) tested = " The case tests " + names + ".";
    else if (!blanks.empty()) tested = " The case tests several blanks: " + std::string(result.which->blanks) + ".";
    return whatIsWrong(result, family) + " " + hint + tested;
}

std::string caseHtml(const CaseResult& result, const Family& family, const std::vector<Blank>& blanks) {
    std::string html = "<p>" + drawing::escapedMarkup(caseText(result, family, blanks)) + "</p>";
    if (result.picture.rgba.empty()) return html;
    return html + imageHtml("png", image::encodePng(result.picture),
                            "The student's picture, what is right, and the difference: " + std::string(result.which->idea));
}

std::string searchHtml(const SearchReport& search, const std::vector<Blank>& blanks) {
    std::string html = "<p>" + drawing::escapedMarkup(toText(search)) + "</p>";
    if (!search.found) return html;
    const FoundScene& found = *search.found;
    html += "<p><strong>" + drawing::escapedMarkup(found.sentence) + "</strong></p>";
    if (!found.counted.empty()) html += "<p>" + drawing::escapedMarkup(found.counted) + "</p>";
    if (const std::string names = namesOf(found.blanks, blanks); !names.empty()) html += "<p>Look first at " + drawing::escapedMarkup(names) + ".</p>";
    if (!found.picture.empty())
        html += imageHtml("png", bytesOf(found.picture), "The student's picture of the scene, what is right, and the difference");
    if (!found.figure.empty()) html += imageHtml("svg+xml", bytesOf(found.figure), "The lecture's figure of a wrong pixel");
    return html;
}

} // namespace shadowlab::student
