// What points cost. They take turns, some frames at a time, so that disturbances by other programs affect all of them alike.
//
// The light turns by one degree from frame to frame, so that nothing which depends on it can be cached. The first frames of a turn do
// not count: the processor's caches still hold the data of the point before. Then the light rests for a frame or two, which are
// counted apart: they show what a technique saves by its own caches.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "app/film/motion.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/report/results.h"

namespace shadowlab::report {

/// How long a turn is. Frames of 100 ms and more get fewer, down to one: they wait for nothing that could disturb them.
struct TurnLength {
    int warming = 3, counted = 5, resting = 2;
};

/// What was measured of a point in one turn. Milliseconds, one for each frame that counts.
struct Turn {
    std::vector<double> frame, prepare, draw, encode, atRest;
    std::vector<Costs::Pass> passes; ///< of one more frame, a clock around each pass
};

/// What was measured of all points of a group: `rounds` of turns, by the point's name.
struct Times {
    using Round = std::map<std::string, Turn>;
    std::vector<Round> rounds;
    std::map<std::string, double> firstMs, residentMegabytes;
};

/// One frame of a slot, of which nothing but the picture is wanted: see FrameRequest::finished. `timesPasses`: with a clock around
/// each pass.
picture::RenderedFrame drawMoment(picture::Session& session, picture::Slot& slot, const film::Moment& moment,
                                  gl::FinishedPicture& finished, ivec2 size, bool timesPasses);

class FrameTimer {
public:
    FrameTimer(picture::Session& session, scene::Snapshot base, ivec2 size, TurnLength length)
        : session_(session), base_(std::move(base)), size_(size), length_(length) {}

    /// Draws the first frame of a new slot. Stores how long its frames take.
    void first(const std::string& name, picture::Slot& slot, Times& times);
    /// One turn in the given round, which says where the light is.
    Turn turn(const std::string& name, picture::Slot& slot, int round);

private:
    picture::RenderedFrame draw(picture::Slot& slot, const film::Moment& moment, bool timesPasses = false) {
        return drawMoment(session_, slot, moment, picture_, size_, timesPasses);
    }
    double encode(picture::Slot& slot, const picture::RenderedFrame& drawn, const film::Moment& moment);
    film::Moment momentOf(int frame);

    picture::Session& session_;
    scene::Snapshot base_, previous_;
    ivec2 size_;
    TurnLength length_;
    picture::PictureEncoder encoder_;
    gl::FinishedPicture picture_;
    std::map<std::string, double> usualMs_;
};

/// The costs of one point of those times; `yardstick` is the point that shadows are counted from. None: not measured.
std::optional<Costs> costsOf(const Times& times, const std::string& point, const std::string& yardstick);

} // namespace shadowlab::report
