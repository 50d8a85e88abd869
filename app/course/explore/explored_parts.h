// The parts of an explorable slide that are not its states: what a legend says, the steps of an algorithm, and what a pixel answers.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "app/course/explore/picture_pack.h"
#include "app/picture/figure.h"
#include "app/picture/session.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

/// [["#d55e00", "in shadow"], ...]; empty for a panel that has a scale.
nlohmann::json legendJson(const picture::Panel& panel);
/// Of a panel whose colours stand for numbers: the least, the greatest, and colours evenly between them; else null.
nlohmann::json scaleJson(const picture::Panel& panel);

/// The picture in the middle of one of that size, the rest transparent: a light's square view beside pictures of the eye's.
image::Image centred(const image::Image& picture, ivec2 size);

/// Points spread evenly over a picture of 16 : 9, in shares of it, about as many as wanted: rows from the top.
std::vector<dvec2> askedPoints(int wanted);

/// What the technique says of the pixel: verdict, facts, and the section through eye, light and point as SVG, as compressed JSON.
std::vector<std::uint8_t> answerOf(picture::Slot& slot, const scene::Snapshot& snapshot, const View& view, int light,
                                   const image::Font& font, const image::Font& bold);

} // namespace shadowlab::course
