// Of some logarithms, one after the other, the logarithm of the mean of what they stand for, without ever forming that: all are
// taken relative to the largest so far.
struct Average {
    float sum, largest, count;
};

Average emptyAverage() { return Average(0.0, -1e30, 0.0); }

void add(inout Average average, vec4 v) {
    float largest = max(average.largest, v.x);
    average.sum = average.sum * exp(average.largest - largest) + exp(v.x - largest);
    average.largest = largest;
    average.count += 1.0;
}

vec4 meanOf(Average average) { return vec4(average.largest + log(average.sum / average.count), 0.0, 0.0, 0.0); }
