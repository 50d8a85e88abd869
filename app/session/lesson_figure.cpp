// SPDX-License-Identifier: MIT
#include "app/session/lesson_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/derived_stages.h"
#include "app/session/difference_panel.h"
#include "app/session/labels.h"
#include "techniques/foundation/error.h"

namespace shadowlab::session {

namespace {

constexpr image::Color8 kGround{16, 16, 18, 255}, kText{245, 245, 245, 255}, kQuiet{178, 178, 182, 255};
constexpr image::Color8 kFrame{0xE6, 0x9F, 0x00, 255}, kFrameEdge{16, 16, 18, 255};
// Type sizes as shares of the figure's height; 1/45 is read from the last row of a lecture hall.
constexpr double kTitleShare = 1.0 / 20, kSettingShare = 1.0 / 42, kLabelShare = 1.0 / 36;
constexpr std::array kSentenceShares = {1.0 / 22, 1.0 / 25, 1.0 / 28,
                                        1.0 / 32}; ///< the first that leaves the pictures whole
constexpr int kLeastPicture = 120;                 ///< pixels: narrower ones show nothing

/// The picture of a state, with titles and legends like those of any capture.
class StatePicture {
public:
    StatePicture(const LessonState& state, ivec2 size, const image::Font& font)
        : state_(state), size_(size), font_(font), session_(state.scene), slots_(slotsOf(state.slots)) {}

    image::Image draw() {
        std::vector<Cell> cells = layoutCells(state_.layout, static_cast<int>(slots_.size()), size_);
        std::vector<Panel> panels;
        if (state_.layout == Layout::diff)
            panels.push_back(difference());
        else
            for (std::size_t i = 0; i < slots_.size(); ++i)
                panels.push_back(panel(i, cells[i]));
        return composeFigure(cells, panels, size_, &font_).picture;
    }

private:
    Panel panel(std::size_t i, Cell& cell) {
        Slot& slot = slots_[i];
        View view;
        view.camera = state_.camera;
        view.size = cell.pictureSize;
        view.region = {ivec2(cell.cropX, 0), ivec2(cell.width, cell.height)};
        std::optional<StageChoice> stage;
        if (!state_.slots[i].stage.empty())
            stage = parseStage(state_.slots[i].stage, *slot.info, *state_.scene, state_.light);
        FrameRequest request;
        if (stage && stage->isPass) request.stopAfter = stage->key;
        if (stage && !stage->isPass) request.stages = neededFor(stage->key);
        const RenderedFrame rendered = session_.render(slot, view, request);
        Panel panel;
        if (stage && stage->key.id == "outside") { // a picture of its own, no band of a larger one
            cell.pictureSize = {cell.width, cell.height};
            cell.cropX = 0;
        }
        if (stage && !stage->isPass && isDerived(stage->key.id)) {
            panel = derivedPanel(session_, slot, rendered, encoder_,
                                 {stage->key, view, std::nullopt, &font_, std::nullopt, cell.pictureSize});
        } else if (stage && !stage->isPass) {
            const Stage& published = findStage(rendered, stage->key);
            panel.kind = stageInfo(*slot.info, published.key.id).kind;
            panel.picture = encoder_.encode(published, panel.kind, state_.scene->exposure);
            panel.display = published.display;
        } else {
            if (stage) requirePassRan(rendered, stage->key, *slot.info);
            panel.picture = encoder_.encode(slot.target.color, state_.scene->exposure);
        }
        if (slots_.size() > 1) panel.title = slot.info->title;
        return panel;
    }

    Panel difference() {
        View view;
        view.camera = state_.camera;
        view.size = size_;
        std::array<measure::Judgement, 2> judgements;
        for (std::size_t i = 0; i < judgements.size(); ++i) {
            FrameRequest request;
            request.stages = {{"visibility", state_.light}};
            const RenderedFrame rendered = session_.render(slots_[i], view, request);
            judgements[i] = measure::judge(session_.truth(view, session_.truthFor(slots_[i], state_.light)),
                                           readVisibility(findStage(rendered, request.stages[0])).greyAlpha);
        }
        return differencePanel(encoder_.encode(slots_[0].target.color, state_.scene->exposure),
                               {&judgements[0], &judgements[1]},
                               {std::string(slots_[0].info->title), std::string(slots_[1].info->title)});
    }

    const LessonState& state_;
    ivec2 size_;
    const image::Font& font_;
    Session session_;
    PictureEncoder encoder_;
    std::vector<Slot> slots_;
};

/// Lines of one text, and how high they are.
struct Lines {
    std::vector<std::string> lines;
    double em = 0;
    int lineHeight = 0;
    [[nodiscard]] int height() const { return static_cast<int>(lines.size()) * lineHeight; }
};
Lines laidOut(const std::string& text, const image::Font& font, double em, int width) {
    Lines lines{font.wrap(text, em, width), em, 0};
    lines.lineHeight = static_cast<int>(std::ceil(font.measure("Xg", em).height * 1.08)); // a little air for the eye
    return lines;
}
int drawLines(image::Image& figure, const Lines& lines, const image::Font& font, int x, int y, image::Color8 color) {
    for (const std::string& line : lines.lines) {
        font.draw(figure, x, y, line, lines.em, color);
        y += lines.lineHeight;
    }
    return y;
}

void drawBoxOutline(image::Image& figure, ivec2 corner, ivec2 size, int width, image::Color8 color) {
    fillRect(figure, corner.x, corner.y, size.x, width, color);
    fillRect(figure, corner.x, corner.y + size.y - width, size.x, width, color);
    fillRect(figure, corner.x, corner.y, width, size.y, color);
    fillRect(figure, corner.x + size.x - width, corner.y, width, size.y, color);
}

/// Frames what to look at. Where the artefact is, it is named: above the box, else below it, else in it, as there is room.
void drawLook(image::Image& picture, const std::vector<LookBox>& look, bool named, const image::Font& font, double em) {
    const ivec2 size(picture.width, picture.height);
    const int line = std::max(2, size.y / 160);
    for (const LookBox& share : look) {
        const LookBox box = inPictureOf(static_cast<double>(size.x) / size.y, share);
        const ivec2 corner(glm::round(box.corner * dvec2(size))), extent(glm::round(box.size * dvec2(size)));
        drawBoxOutline(picture, corner - line / 2 - 1, extent + 2 * (line / 2 + 1), line + 2, kFrameEdge);
        drawBoxOutline(picture, corner - line / 2, extent + 2 * (line / 2), line, kFrame);
        if (!named) continue;
        const Plate plate = titlePlate(share.label, font, em, size.x / 2);
        int y = corner.y - line - plate.height;
        if (y < 0) y = corner.y + extent.y + line;
        if (y + plate.height > size.y) y = corner.y + line;
        drawPlate(picture, plate, std::clamp(corner.x, 0, std::max(0, size.x - plate.width)), y);
    }
}

/// "shadow-map.bias-mode=none" as a line below the sentence: what makes the state what it is.
std::string settingsLine(const LessonState& state) {
    std::string line;
    for (const std::string& setting : state.settings)
        line += (line.empty() ? "" : ",  ") + setting;
    return line;
}

/// What stands below one picture.
struct Column {
    Lines heading, sentence, settings;
    [[nodiscard]] int height() const { return heading.height() + sentence.height() + settings.height(); }
};

} // namespace

std::string stateTitle(std::size_t state) { return state == 0 ? "1 of 2: the artefact" : "2 of 2: the mend"; }

const std::string& sentenceOf(const Lesson& lesson, std::size_t state) {
    return state == 0 ? lesson.text.happens : lesson.text.mends;
}

image::Image lessonFigure(const Lesson& lesson, const ShownStates& states, ivec2 size, const image::Font& font,
                          const image::Font& bold) {
    const auto columns = static_cast<int>(states.size());
    const int pad = std::max(4, size.y / 60);
    const int columnWidth = (size.x - (columns + 1) * pad) / columns;
    const Lines title = laidOut(lesson.text.title, bold, size.y * kTitleShare, size.x - 2 * pad);
    const int top = title.height() + 2 * pad;
    const int wholeHeight = static_cast<int>(std::lround(columnWidth / kLessonAspect));
    std::vector<Column> texts;
    int room = 0;
    for (const double share : kSentenceShares) {
        texts.clear();
        int textHeight = 0;
        for (const std::size_t state : states) {
            const LessonState& shown = lesson.states[state];
            texts.push_back({laidOut(stateTitle(state), bold, size.y * share, columnWidth),
                             laidOut(sentenceOf(lesson, state), font, size.y * share, columnWidth - pad),
                             laidOut(settingsLine(shown), font, size.y * kSettingShare, columnWidth)});
            textHeight = std::max(textHeight, texts.back().height());
        }
        room = size.y - top - textHeight - 2 * pad;
        if (room >= wholeHeight) break;
    }
    const int pictureHeight = std::min(room, wholeHeight);
    const ivec2 pictureSize(std::min(columnWidth, static_cast<int>(std::lround(pictureHeight * kLessonAspect))),
                            pictureHeight);
    if (pictureSize.x < kLeastPicture)
        throw Error(ExitStatus::usage, "--size: " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                                           " has no room for pictures beside the words; choose a larger size");

    image::Image figure(size.x, size.y, kGround);
    drawLines(figure, title, bold, pad, pad, kText);
    for (int i = 0; i < columns; ++i) {
        const auto column = static_cast<std::size_t>(i);
        const int x = pad + i * (columnWidth + pad);
        image::Image picture = StatePicture(lesson.states[states[column]], pictureSize, font).draw();
        drawLook(picture, lesson.look, states[column] == 0, font, std::max(10.0, size.y * kLabelShare));
        blit(figure, x + (columnWidth - pictureSize.x) / 2, top, picture);
        int y = top + pictureHeight + pad;
        y = drawLines(figure, texts[column].heading, bold, x, y, kFrame);
        y = drawLines(figure, texts[column].sentence, font, x, y, kText);
        drawLines(figure, texts[column].settings, font, x, y, kQuiet);
    }
    return figure;
}

} // namespace shadowlab::session
