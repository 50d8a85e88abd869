// SPDX-License-Identifier: MIT
#include "app/judge/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/gtc/constants.hpp>

#include "app/judge/metrics/opponent_colors.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

namespace {

using Plane = Grid<float>;
using Kernel = std::vector<float>; ///< odd length, the middle is 0

constexpr double kPi = glm::pi<double>();

// The paper's constants. Exponents of the two pipelines, and how differences of colour are spread over 0..1: up to the
// share kPc of the largest one takes the range up to kPt, what is larger is pressed into the rest.
constexpr float kQc = 0.7f, kQf = 0.5f, kPc = 0.4f, kPt = 0.95f;
constexpr double kFeatureWidthDegrees = 0.082; ///< from peak to trough of the eye's detector of edges

/// Sensitivity to contrast, as one or two Gaussians a * sqrt(pi / b) * exp(-pi^2 x^2 / b), x in degrees.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic{1, 0.0047, 0, 1e-5}, kRedGreen{1, 0.0053, 0, 1e-5},
    kBlueYellow{34.1, 0.04, 13.5, 0.025};

/// Three standard deviations of the widest of the Gaussians.
int sensitivityRadius(double pixelsPerDegree) {
    return static_cast<int>(std::ceil(3 * std::sqrt(kBlueYellow.b1 / (2 * kPi * kPi)) * pixelsPerDegree));
}

/// exp(-pi^2 x^2 / b) along one axis, and its sum before it is divided by it.
struct Gaussian {
    Kernel kernel;
    double sum = 0;
};
Gaussian gaussian(double b, int radius, double pixelsPerDegree) {
    Gaussian g;
    std::vector<double> values;
    for (int i = -radius; i <= radius; ++i)
        values.push_back(std::exp(-kPi * kPi * (i / pixelsPerDegree) * (i / pixelsPerDegree) / b));
    g.sum = std::accumulate(values.begin(), values.end(), 0.0);
    for (const double value : values)
        g.kernel.push_back(static_cast<float>(value / g.sum));
    return g;
}

/// `across` along the rows, then `down` along the columns; beyond its border a picture goes on as it ends.
Plane filtered(const Plane& source, const Kernel& across, const Kernel& down) {
    const int width = source.width, height = source.height;
    const int reachX = static_cast<int>(across.size() / 2), reachY = static_cast<int>(down.size() / 2);
    Plane rows(width, height), result(width, height);
    const auto row = [](auto& plane, int y) { return plane.values.data() + plane.index(0, y); };
    trace::parallelFor(static_cast<std::size_t>(height), [&](std::size_t line) {
        const int y = static_cast<int>(line);
        std::vector<float> padded(static_cast<std::size_t>(width + 2 * reachX));
        for (int x = 0; x < width + 2 * reachX; ++x)
            padded[static_cast<std::size_t>(x)] = source.at(std::clamp(x - reachX, 0, width - 1), y);
        float* const out = row(rows, y);
        for (std::size_t i = 0; i < across.size(); ++i)
            for (int x = 0; x < width; ++x)
                out[x] += across[i] * padded[i + static_cast<std::size_t>(x)];
    });
    trace::parallelFor(static_cast<std::size_t>(height), [&](std::size_t line) {
        const int y = static_cast<int>(line);
        float* const out = row(result, y);
        for (std::size_t j = 0; j < down.size(); ++j) {
            const float* const in = row(rows, std::clamp(y + static_cast<int>(j) - reachY, 0, height - 1));
            for (int x = 0; x < width; ++x)
                out[x] += down[j] * in[x];
        }
    });
    return result;
}

/// Blurred as the eye blurs that channel. Two Gaussians are two blurs, mixed as their sums in two dimensions are.
Plane blurred(const Plane& channel, const Sensitivity& sensitivity, double pixelsPerDegree) {
    const int radius = sensitivityRadius(pixelsPerDegree);
    const Gaussian first = gaussian(sensitivity.b1, radius, pixelsPerDegree);
    Plane result = filtered(channel, first.kernel, first.kernel);
    if (sensitivity.a2 == 0) return result;
    const Gaussian second = gaussian(sensitivity.b2, radius, pixelsPerDegree);
    const double p = sensitivity.a1 * std::sqrt(kPi / sensitivity.b1) * first.sum * first.sum;
    const double q = sensitivity.a2 * std::sqrt(kPi / sensitivity.b2) * second.sum * second.sum;
    const Plane other = filtered(channel, second.kernel, second.kernel);
    const auto share = static_cast<float>(q / (p + q));
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = std::lerp(result.values[i], other.values[i], share);
    return result;
}

/// The channels of a picture in YCxCz.
struct Channels {
    Plane y, cx, cz;
};
Channels channelsOf(const image::Image& picture) {
    Channels channels{Plane(picture.width, picture.height), Plane(picture.width, picture.height),
                      Plane(picture.width, picture.height)};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const image::Color8 c = picture.at(x, y);
            const vec3 ycxcz =
                ycxczFromLinear({image::linearFromSrgb(c.r), image::linearFromSrgb(c.g), image::linearFromSrgb(c.b)});
            channels.y.at(x, y) = ycxcz.x, channels.cx.at(x, y) = ycxcz.y, channels.cz.at(x, y) = ycxcz.z;
        }
    return channels;
}

/// What is seen of the picture's colours, per pixel in Hunt-adjusted L*a*b*.
Grid<vec3> perceivedColors(const Channels& channels, double pixelsPerDegree) {
    const Plane y = blurred(channels.y, kAchromatic, pixelsPerDegree),
                cx = blurred(channels.cx, kRedGreen, pixelsPerDegree),
                cz = blurred(channels.cz, kBlueYellow, pixelsPerDegree);
    Grid<vec3> colors(y.width, y.height);
    trace::parallelFor(static_cast<std::size_t>(y.height), [&](std::size_t line) {
        for (std::size_t i = line * static_cast<std::size_t>(y.width);
             i < (line + 1) * static_cast<std::size_t>(y.width); ++i) {
            const vec3 rgb = linearFromYcxcz({y.values[i], cx.values[i], cz.values[i]});
            colors.values[i] = huntAdjusted(labFromLinear(glm::clamp(rgb, 0.0f, 1.0f)));
        }
    });
    return colors;
}

/// Weights above zero sum to one, and those below to minus one.
Kernel balanced(const std::vector<double>& values) {
    double positive = 0, negative = 0;
    for (const double value : values)
        (value > 0 ? positive : negative) += std::abs(value);
    Kernel kernel;
    for (const double value : values)
        kernel.push_back(static_cast<float>(value / (value > 0 ? positive : negative)));
    return kernel;
}

/// How strong edges, and points, are at each pixel.
struct Features {
    Plane edges, points;
};
Features featuresOf(const Plane& y, double pixelsPerDegree) {
    const double deviation = 0.5 * kFeatureWidthDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    std::vector<double> gauss, first, second; // the Gaussian and its derivatives, up to factors that balanced() removes
    for (int i = -radius; i <= radius; ++i) {
        const double g = std::exp(-i * i / (2 * deviation * deviation));
        gauss.push_back(g);
        first.push_back(-i * g);
        second.push_back((i * i / (deviation * deviation) - 1) * g);
    }
    const Kernel blur = balanced(gauss), edge = balanced(first), point = balanced(second);
    Plane light = y; // 0 for black, 1 for white
    for (float& value : light.values)
        value = (value + 16.0f) / 116.0f;
    const auto strength = [&](const Kernel& kernel) {
        Plane alongX = filtered(light, kernel, blur);
        const Plane alongY = filtered(light, blur, kernel);
        for (std::size_t i = 0; i < alongX.values.size(); ++i)
            alongX.values[i] = std::hypot(alongX.values[i], alongY.values[i]);
        return alongX;
    };
    return {strength(edge), strength(point)};
}

/// The largest difference of colour that there is between colours of sRGB: green against blue.
float largestColorDifference() {
    return std::pow(hyab(huntAdjusted(labFromLinear({0, 1, 0})), huntAdjusted(labFromLinear({0, 0, 1}))), kQc);
}

float spread(float difference, float largest) {
    const float raised = std::pow(difference, kQc), knee = kPc * largest;
    if (raised < knee) return kPt / knee * raised;
    return kPt + (raised - knee) / (largest - knee) * (1.0f - kPt);
}

} // namespace

Flip flip(const image::Image& reference, const image::Image& test, double pixelsPerDegree) {
    const Channels channelsA = channelsOf(reference), channelsB = channelsOf(test);
    const Grid<vec3> colorsA = perceivedColors(channelsA, pixelsPerDegree),
                     colorsB = perceivedColors(channelsB, pixelsPerDegree);
    const Features featuresA = featuresOf(channelsA.y, pixelsPerDegree),
                   featuresB = featuresOf(channelsB.y, pixelsPerDegree);
    const float largest = largestColorDifference();
    Flip result{Grid<float>(reference.width, reference.height), 0};
    trace::parallelFor(static_cast<std::size_t>(reference.height), [&](std::size_t line) {
        const auto width = static_cast<std::size_t>(reference.width);
        for (std::size_t i = line * width; i < (line + 1) * width; ++i) {
            const float color = spread(hyab(colorsA.values[i], colorsB.values[i]), largest);
            const float edges = std::abs(featuresA.edges.values[i] - featuresB.edges.values[i]);
            const float points = std::abs(featuresA.points.values[i] - featuresB.points.values[i]);
            const float feature = std::pow(std::max(edges, points) / std::sqrt(2.0f), kQf);
            result.map.values[i] = std::pow(color, 1.0f - feature);
        }
    });
    const double sum = std::accumulate(result.map.values.begin(), result.map.values.end(), 0.0);
    result.mean = sum / static_cast<double>(result.map.values.size());
    return result;
}

} // namespace shadowlab::judge
