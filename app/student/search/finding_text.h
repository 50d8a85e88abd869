// What a search has found, in words: a sentence, and a lesson.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/student/blanks.h"
#include "app/student/search/search.h"

namespace shadowlab::student {

/// "two triangles and a lamp"
std::string sceneInWords(const SearchScene& scene);

/// "Two triangles and a lamp: here your shadow is missing. ..." Says what is observed, and where.
std::string sentenceOf(const Finding& finding);

/// The blanks that it may be about, by number: those that the cases of the score sheet tell of (`bySheet`, likelyBlanks()), else those of
/// the scene's kind; and of these, where a stage of the plug-in is the first that is wrong, those in the source of the passes that lead to it.
std::vector<int> blanksAbout(const Finding& finding, const Family& family, const std::vector<Blank>& blanks,
                             const std::vector<int>& bySheet);

/// A lesson (docs/lessons.md) about the scene STEM.json beside it: before, the plug-in's technique; after, the lecture's.
std::string lessonText(const Finding& finding, const Candidate& candidate, const Family& family, const std::string& stem);

} // namespace shadowlab::student
