// SPDX-License-Identifier: MIT
#include "app/course/exercises/sheet_page.h"

#include <cmath>
#include <string_view>

#include "app/course/exercises/page_filling.h"
#include "app/drawing/markup.h"
#include "app/drawing/prose.h"

namespace shadowlab::course {

namespace {

// An exercise stays on one page, its figure and room for answers included: page_filling.h knows the heights that follow from this style.
// The page's foot says which sheet it is of, because sheets get mixed up.
constexpr std::string_view kSheetStyle = R"(
:root { color-scheme: light }
* { box-sizing: border-box }
body { margin: 0 auto; padding: 1rem; max-width: 186mm; background: #fff; color: #1a1a1a;
  font: 10.5pt/1.45 'DejaVu Sans', Verdana, sans-serif }
header { border-bottom: 1.5pt solid #1a1a1a; margin-bottom: 5mm; padding-bottom: 3mm }
h1 { font-size: 15pt; margin: 0 0 5mm }
.who { display: flex; gap: 8mm }
.who span { display: flex; flex: 2; gap: 2mm; align-items: end }
.who span + span { flex: 1 }
.who span::after { content: ''; flex: 1; border-bottom: .8pt solid #1a1a1a }
section { break-inside: avoid }
h2 { font-size: 11.5pt; margin: 5mm 0 1.5mm; break-after: avoid }
.given { margin: 0 0 2mm }
figure { margin: 2mm auto 3mm; text-align: center }
figure svg { display: block; width: 100%; height: auto; margin: 0 auto }
ol { list-style: lower-alpha; margin: 0; padding-left: 6mm }
li { margin-bottom: 2mm }
.room { height: 16mm; border-bottom: .6pt dotted #888 }
.room i { display: block; height: 8mm; border-bottom: .6pt dotted #888 }
.told { margin: 1.5mm 0 }
math mi, math mn, math mtext { font-family: 'DejaVu Sans', Verdana, sans-serif }
math .variable { font-style: italic }
math .vector { font-weight: bold }
@media print { body { padding: 0; max-width: none } }
)";

/// Letter paper is shorter than A4; with smaller margins its text is nearly as high.
std::string_view pageSize(Paper paper) {
    return paper == Paper::letter ? "size: letter; margin: 10mm 16mm 14mm" : "size: A4; margin: 16mm 16mm 18mm";
}

/// The SVG element alone: the declaration above it belongs to a file.
std::string inlineFigure(const ExerciseFigure& figure) {
    const std::string document = figure.drawing.document(figure.title);
    const long millimetres = std::lround(figure.drawing.size().x * kMillimetresOfPixel);
    return "<figure style=\"max-width: " + std::to_string(millimetres) + "mm\">" +
           document.substr(document.find("<svg")) + "</figure>\n";
}

std::string pageOf(const std::string& title, const std::string& foot, Paper paper, const std::string& bodyClass,
                   const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width\">\n<title>" +
           drawing::escapedMarkup(title) + "</title>\n<style>" + std::string(kSheetStyle) + "@page { " +
           std::string(pageSize(paper)) +
           "; @bottom-center { font: 8pt 'DejaVu Sans', Verdana, sans-serif; content: \"" + foot +
           ", page \" counter(page) \" of \" counter(pages) } }\n</style>\n</head>\n<body class=\"" + bodyClass +
           "\">\n" + body + "</body>\n</html>\n";
}

std::string headingOf(std::size_t number, const Exercise& exercise) {
    return "<h2>" + std::to_string(number + 1) + ". " + drawing::escapedMarkup(exercise.title) + "</h2>\n";
}

} // namespace

std::string sheetPage(const std::vector<Exercise>& exercises, std::uint64_t seed, Paper paper) {
    const std::string name = "Sheet " + std::to_string(seed),
                      title = "Shadows: exercises, sheet " + std::to_string(seed);
    std::string body = "<header>\n<h1>" + title +
                       "</h1>\n<div class=\"who\"><span>Name</span><span>Date</span></div>\n</header>\n";
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const Exercise& exercise = exercises[i];
        body += "<section>\n" + headingOf(i, exercise) + "<p class=\"given\">" + drawing::proseMarkup(exercise.given) +
                "</p>\n";
        if (exercise.figure) body += inlineFigure(*exercise.figure);
        body += "<ol>\n";
        for (const std::string& question : exercise.questions)
            body += "<li>" + drawing::proseMarkup(question) + "<div class=\"room\"><i></i></div></li>\n";
        body += "</ol>\n</section>\n";
    }
    return pageOf(title, name, paper, "sheet", body);
}

std::string keyPage(const std::vector<Exercise>& exercises, std::uint64_t seed, Paper paper) {
    const std::string name = "Key to sheet " + std::to_string(seed);
    std::string body = "<header>\n<h1>" + name + "</h1>\n</header>\n";
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const Exercise& exercise = exercises[i];
        body += "<section>\n" + headingOf(i, exercise) + "<ol>\n";
        for (const std::string& answer : exercise.answers)
            body += "<li>" + drawing::proseMarkup(answer) + "</li>\n";
        body += "</ol>\n<p class=\"told\">" + drawing::proseMarkup(exercise.working) +
                "</p>\n<p class=\"told\"><em>Usual mistake:</em> " + drawing::proseMarkup(exercise.mistake) +
                "</p>\n</section>\n";
    }
    return pageOf(name, name, paper, "key", body);
}

} // namespace shadowlab::course
