// The mean of some vectors, one after the other; of logarithms the logarithm of the mean of what they stand for, without ever
// forming that: all are taken relative to the largest so far.
uniform int averageLogarithms;

struct Average {
    vec4 sum;
    float largest, count;
};

Average emptyAverage() { return Average(vec4(0.0), -1e30, 0.0); }

void add(inout Average average, vec4 v) {
    average.count += 1.0;
    if (averageLogarithms == 0) {
        average.sum += v;
        return;
    }
    float largest = max(average.largest, v.x);
    average.sum.x = average.sum.x * exp(average.largest - largest) + exp(v.x - largest);
    average.largest = largest;
}

vec4 meanOf(Average average) {
    vec4 mean = average.sum / average.count;
    return averageLogarithms == 0 ? mean : vec4(average.largest + log(mean.x), 0.0, 0.0, 0.0);
}
