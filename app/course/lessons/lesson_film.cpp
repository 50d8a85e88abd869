// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson_film.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "app/course/lessons/lesson_drawing.h"
#include "app/course/lessons/lesson_figure.h"
#include "app/course/state_motion.h"
#include "app/course/state_picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {

namespace {

constexpr double kSentenceShare = 1.0 / 27; // of the height: two sentences take three lines
constexpr int kLeastFilmWidth = 120;        // pixels: narrower ones show nothing

// Subtitles are made for 160 to 180 words a minute (BBC, Subtitle Guidelines); who reads here has to look at the picture as well.
constexpr double kWordsPerSecond = 160.0 / 60, kLookSeconds = 4;

// Once is missed by who has just looked up from the words.
constexpr int kTimesToAndFro = 3;

// Bluish green of Okabe and Ito's colours, over the picture: what is right, as in the window.
constexpr image::Color8 kTrueShadow{0x00, 0x9E, 0x73, 255};
constexpr float kTrueShadowCoverage = 0.78f;

/// What stands below a picture.
struct Words {
    std::string heading, sentence, quiet;
    std::vector<std::pair<std::string, image::Color8>> choices;
};

Words wordsOf(const Lesson& lesson, LessonShot shot) {
    if (shot == LessonShot::artefact || shot == LessonShot::remedy) {
        const std::size_t state = shot == LessonShot::artefact ? 0 : 1;
        return {stateTitle(state), sentenceOf(lesson, state), settingsLine(lesson.states[state]), {}};
    }
    const bool isAnswer = shot == LessonShot::answer;
    const Question& question = *lesson.question;
    Words words{isAnswer ? "The answer" : "What do you expect?", question.text, "", {}};
    if (question.kind == Question::Kind::mark && isAnswer)
        words.choices.emplace_back("Green: the shadow, where it falls.", kTrueShadow);
    for (std::size_t i = 0; i < question.choices.size(); ++i) {
        const bool isRight = static_cast<int>(i) == question.right;
        words.choices.emplace_back((isAnswer && isRight ? "» " : "   ") + std::to_string(i + 1) + "   " +
                                       question.choices[i],
                                   !isAnswer ? kLessonText
                                   : isRight ? kTrueShadow
                                             : kLessonQuiet);
    }
    return words;
}

/// The same place for the pictures of all shots, so that only what differs changes.
class Page {
public:
    Page(const Lesson& lesson, ivec2 size, const image::Font& font, const image::Font& bold)
        : size_(size), font_(font), bold_(bold), pad_(std::max(4, size.y / 60)),
          title_(laidOut(lesson.text.title, bold, size.y * kLessonTitleShare, size.x - 2 * pad_)) {
        int wordsHeight = 0;
        for (const LessonShot shot : shotsOf(lesson))
            for (const Placed& one : placed(wordsOf(lesson, shot)))
                wordsHeight = std::max(wordsHeight, one.y + one.lines.height());
        top_ = title_.height() + 2 * pad_;
        const int room = size.y - top_ - wordsHeight - 2 * pad_;
        const int width = std::min(size.x - 2 * pad_, static_cast<int>(std::lround(room * kLessonAspect)));
        pictureSize_ = {width, std::min(room, static_cast<int>(std::lround(width / kLessonAspect)))};
        if (width < kLeastFilmWidth)
            throw Error(ExitStatus::usage, "--size: " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                                               " has no room for a picture beside the words; choose a larger size");
    }

    [[nodiscard]] ivec2 pictureSize() const { return pictureSize_; }

    [[nodiscard]] image::Image with(const image::Image& picture, const Words& words) const {
        image::Image page(size_.x, size_.y, kLessonGround);
        drawLines(page, title_, bold_, pad_, pad_, kLessonText);
        blit(page, (size_.x - picture.width) / 2, top_, picture);
        for (const Placed& one : placed(words))
            drawLines(page, one.lines, *one.font, one.x, top_ + pictureSize_.y + pad_ + one.y, one.color);
        return page;
    }

private:
    /// A piece of text, in pixels from the left border and from where the words begin.
    struct Placed {
        Lines lines;
        const image::Font* font;
        image::Color8 color;
        int x, y;
    };
    [[nodiscard]] std::vector<Placed> placed(const Words& words) const {
        const int width = size_.x - 2 * pad_;
        std::vector<Placed> all;
        int y = 0;
        const auto add = [&](const std::string& text, const image::Font& font, double share, image::Color8 color) {
            all.push_back({laidOut(text, font, size_.y * share, width), &font, color, pad_, y});
            y += all.back().lines.height();
        };
        add(words.heading, bold_, kSentenceShare, kLessonAccent);
        add(words.sentence, font_, kSentenceShare, kLessonText);
        add(words.quiet, font_, kLessonSettingShare, kLessonQuiet);
        // Choices stand in two columns: one below the other they would leave the picture small.
        for (std::size_t i = 0; i < words.choices.size(); i += 2) {
            int height = 0;
            for (std::size_t j = i; j < std::min(i + 2, words.choices.size()); ++j) {
                const auto& [text, color] = words.choices[j];
                const int x = pad_ + static_cast<int>(j - i) * (width / 2);
                all.push_back({laidOut(text, font_, size_.y * kSentenceShare, width / 2 - pad_), &font_, color, x, y});
                height = std::max(height, all.back().lines.height());
            }
            y += height;
        }
        return all;
    }

    ivec2 size_;
    const image::Font &font_, &bold_;
    int pad_, top_ = 0;
    Lines title_;
    ivec2 pictureSize_{0};
};

/// Before a shadow is revealed, none of it is seen.
ShownState stateOf(const Lesson& lesson, LessonShot shot) {
    if (shot == LessonShot::artefact || shot == LessonShot::remedy)
        return lesson.states[shot == LessonShot::artefact ? 0 : 1];
    if (lesson.question->kind == Question::Kind::choice) return lesson.states[lesson.question->picture];
    ShownState bare = lesson.states[0];
    bare.slots = {{.technique = "unshadowed", .stage = {}, .settings = {}}};
    bare.layout = picture::Layout::single;
    return bare;
}

void layTrueShadowOver(image::Image& picture, const ShownState& state) {
    picture::Session session(state.scene);
    View view;
    view.camera = state.camera;
    view.size = {picture.width, picture.height};
    const judge::Truth truth = session.truthAtCentres(view, {state.light});
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (truth.visibility[truth.index(x, y)] == trace::Visibility::shadowed)
                blendPixel(picture, x, y, kTrueShadow, kTrueShadowCoverage);
}

image::Image drawShot(const Lesson& lesson, LessonShot shot, const ShownState& state, const Page& page, ivec2 size,
                      const image::Font& font) {
    image::Image picture = drawState(state, {.size = page.pictureSize()}, font);
    if (shot == LessonShot::artefact || shot == LessonShot::remedy)
        drawLook(picture, lesson.look, shot == LessonShot::artefact, font, std::max(10.0, size.y * kLessonLabelShare));
    else if (shot == LessonShot::answer && lesson.question->kind == Question::Kind::mark)
        layTrueShadowOver(picture, state);
    return picture;
}

/// All frames of the motion but the first, which was shown already, and back again to it.
void addMotion(const Lesson& lesson, LessonShot shot, const Page& page, ivec2 size, const image::Font& font,
               film::Film& film) {
    const Words words = wordsOf(lesson, shot);
    std::vector<image::Image> pages;
    for (const ShownState& state : statesInMotion(stateOf(lesson, shot), lesson.motion))
        pages.push_back(page.with(drawShot(lesson, shot, state, page, size, font), words));
    const int last = lesson.motion.frames - 1;
    for (int i = 1; i <= 2 * last * kTimesToAndFro; ++i) {
        const int phase = i % (2 * last);
        film.add(pages[static_cast<std::size_t>(phase <= last ? phase : 2 * last - phase)]);
    }
}

} // namespace

std::vector<LessonShot> shotsOf(const Lesson& lesson) {
    std::vector<LessonShot> shots;
    if (lesson.question) shots = {LessonShot::question, LessonShot::answer};
    shots.insert(shots.end(), {LessonShot::artefact, LessonShot::remedy});
    return shots;
}

int readingTicks(const Lesson& lesson, LessonShot shot) {
    const Words words = wordsOf(lesson, shot);
    std::string all = words.sentence;
    if (shot == LessonShot::question)
        for (const auto& [line, color] : words.choices)
            all += " " + line;
    if (shot == LessonShot::answer) all.clear(); // it was read with the question
    if (shot == LessonShot::artefact)
        for (const LookBox& box : lesson.look)
            all += " " + box.label;
    std::istringstream stream(all);
    int count = 0;
    for (std::string word; stream >> word;)
        ++count;
    const double seconds = kLookSeconds + count / kWordsPerSecond;
    return static_cast<int>(std::ceil(seconds * kLessonTick.denominator / kLessonTick.numerator));
}

void filmLesson(const Lesson& lesson, const LessonFilmSettings& settings, const image::Font& font,
                const image::Font& bold, film::Film& film) {
    const Page page(lesson, settings.size, font, bold);
    for (const LessonShot shot : shotsOf(lesson)) {
        const int ticks =
            settings.holdSeconds
                ? std::max(1, static_cast<int>(std::lround(*settings.holdSeconds * kLessonTick.denominator)))
                : readingTicks(lesson, shot);
        film.add(
            page.with(drawShot(lesson, shot, stateOf(lesson, shot), page, settings.size, font), wordsOf(lesson, shot)),
            ticks);
        const bool moves = shot == LessonShot::artefact || shot == LessonShot::remedy;
        if (moves && lesson.motion.frames > 1) addMotion(lesson, shot, page, settings.size, font, film);
    }
}

} // namespace shadowlab::course
