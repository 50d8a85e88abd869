// How a technique is marked in charts and tables: a colour and a shape of its own, either of which identifies it.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>

#include "app/drawing/drawing.h"
#include "app/report/results.h"

namespace shadowlab::report {

struct TechniqueMark {
    std::string color;
    int shape = 0;
};

/// Of all techniques of a group, by id. The program's own are marked by their place in its list, the same in every chart; others
/// take the places behind. The first eight differ in both colour and shape, the first 64 in the pair.
std::map<std::string, TechniqueMark> marksOf(const Group& group);

/// A marker around `place`, its corners `radius` pixels away. `isOpen`: white inside.
void drawMark(drawing::Drawing& drawing, dvec2 place, const TechniqueMark& mark, double radius, bool isOpen);

} // namespace shadowlab::report
