// What of a technique is shown: the finished picture, one of its stages, or the picture after one of its passes. A StageRef
// is read from text where text enters the program (command line, decks, lessons) and written where it leaves; between, it is
// a value. The spelling of stages is defined here alone.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "techniques/frame.h"

namespace shadowlab::picture {

/// A requested stage, not yet resolved against a scene and a technique. The default is the finished picture.
struct StageRef {
    std::string id{};                   ///< of the stage or the pass
    std::optional<std::string> light{}; ///< its name; none: the light that all stages are about
    bool isPass = false;                ///< the picture after that pass
    friend bool operator==(const StageRef&, const StageRef&) = default;

    /// `STAGE`, `STAGE@LIGHT` or `pass:ID[@LIGHT]`; empty: the finished picture. An id has no '@', so the first one ends it;
    /// a light's name may have more. Whether there is such a stage is seen by resolve().
    static StageRef parse(std::string_view text);
    /// A pass without the word before it, as decks write a step: `ID` or `ID@LIGHT`.
    static StageRef parsePass(std::string_view idAndLight);
    /// What parse() makes this of.
    [[nodiscard]] std::string text() const;
    /// What parsePass() makes this of, where it is a pass.
    [[nodiscard]] std::string idAndLight() const;
    /// The same stage of the light that all stages are about.
    [[nodiscard]] StageRef ofAnyLight() const { return {id, {}, isPass}; }

    [[nodiscard]] bool isPicture() const { return *this == StageRef{}; }
    [[nodiscard]] bool isVisibility() const;
    /// Is it a stage that the session makes, not the technique?
    [[nodiscard]] bool isDerived() const;
    /// Is it a stage that shows verdicts: `truth`, `error`, `scanline`? The window finds them in the background.
    [[nodiscard]] bool isJudged() const;
    [[nodiscard]] bool isTruth() const;
    [[nodiscard]] bool isError() const;
    [[nodiscard]] bool isScanline() const;
    [[nodiscard]] bool isShadowOutline() const;
    /// Is it what the second camera sees?
    [[nodiscard]] bool isOutside() const;
};

/// The same for one technique in one scene: it has that stage or pass, and the light is a number.
struct ResolvedStage {
    StageKey key;        ///< its id is empty for the finished picture
    bool isPass = false; ///< the picture after that pass

    [[nodiscard]] bool isPicture() const { return key.id.empty(); }
    /// Is it a texture beside the picture: neither the picture itself nor what a pass leaves of it?
    [[nodiscard]] bool isStage() const { return !isPicture() && !isPass; }
    [[nodiscard]] StageRef ofAnyLight() const { return {key.id, {}, isPass}; }
    [[nodiscard]] bool isDerived() const { return ofAnyLight().isDerived(); }
    [[nodiscard]] bool isJudged() const { return ofAnyLight().isJudged(); }
    [[nodiscard]] bool isShadowOutline() const { return ofAnyLight().isShadowOutline(); }
    [[nodiscard]] bool isOutside() const { return ofAnyLight().isOutside(); }
};

/// A stage of one light that names none is that of `defaultLight` (kNoLight: the first). Throws Error (usage) for an unknown
/// stage, pass or light, naming what there is, and for a light where the stage has none.
ResolvedStage resolve(const StageRef& stage, const TechniqueInfo& info, const scene::Scene& scene, int defaultLight);

/// A pass or stage that ran, to be found again: its light by name.
StageRef refOf(const StageKey& key, bool isPass, const scene::Scene& scene);

/// What a technique says of one light: its stage `visibility`.
StageKey visibilityOf(int light);

} // namespace shadowlab::picture
