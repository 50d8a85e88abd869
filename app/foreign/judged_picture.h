// A foreign picture held against the truth: the same numbers as of a technique (judge/slot_errors.h), and what is wrong with it.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "app/foreign/diagnosis.h"
#include "app/foreign/seen_encoding.h"
#include "app/judge/slot_errors.h"

namespace shadowlab::foreign {

struct JudgedPicture {
    judge::TruthOf truthOf = judge::TruthOf::centre;
    judge::Truth truth; ///< with ties also where the picture cannot be judged
    FoundVisibility found;
    judge::SlotErrors errors; ///< ties are those of the truth alone
    int core = 0;
    std::optional<judge::Displacement> boundaryPx;
    std::optional<SeenEncoding> encoding; ///< another than it should be
    std::optional<int> white;  ///< of a visibility image whose white is not 255: that grey; it is judged as if it were 255
    std::string remark;        ///< what the pictures are wrong in as a whole, as a sentence without its end; empty: nothing
    Diagnosis diagnosis;
    [[nodiscard]] bool isRight() const {
        return errors.judgement.counts.wrong() == 0 && errors.judgement.counts.stray == 0 && !encoding && !white;
    }
};

/// `truthOf`: area only of a light that has one. `reference`: the picture without shadows; null: the picture is a visibility image. Both
/// have that size. Throws Error (badInput), which names no file, where a picture is not what it should be.
JudgedPicture judgePicture(const scene::Snapshot& scene, int light, judge::TruthOf truthOf, const image::Image& picture,
                           const image::Image* reference);
/// By what a light is judged that the picture's program knows as the scene has it.
inline judge::TruthOf truthOfLight(const scene::Light& light) {
    return scene::hasArea(light) ? judge::TruthOf::area : judge::TruthOf::centre;
}

} // namespace shadowlab::foreign
