// How different are two pictures? Two established numbers, kept because they are quoted everywhere; FLIP (flip.h) predicts better
// what people see.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/image/image.h"

namespace shadowlab::judge {

/// Peak signal to noise ratio in dB, -20 log10 of the root of the mean squared difference, over all numbers of two
/// pictures of one size in linear light, with 1 as the peak. Infinite when they are equal.
double psnr(std::span<const float> a, std::span<const float> b);

/// Mean structural similarity of two pictures of one size, -1 to 1, 1 for equal ones: Wang, Bovik, Sheikh and
/// Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE Transactions on Image
/// Processing 13(4), 2004, with their constants: a Gaussian window of 11 x 11 pixels and 1.5 pixels deviation, K1 =
/// 0.01, K2 = 0.03. It looks at the luma (Rec. 601, as they did) of the encoded picture, and at those windows that lie
/// inside; a picture smaller than a window is one window as large as itself.
double ssim(const image::Image& a, const image::Image& b);

} // namespace shadowlab::judge
