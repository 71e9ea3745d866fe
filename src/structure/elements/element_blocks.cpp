#include "structure/elements/element_blocks.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"

namespace corpuscle {

ElementBlocks::ElementBlocks(std::size_t elements, int slots) : size_(elements), slots_(slots)
{
    const std::size_t padded = (elements + lane_count - 1) / lane_count * lane_count;
    data_.assign(static_cast<std::size_t>(slots) * (padded / lane_count), Lanes(0.0));
    left_.assign(padded, 1.0);
    transit_.assign(padded, 0.0);
}

void ElementBlocks::remove(std::size_t element)
{
    left_[element] = 0;
    for (std::size_t e = size_; element + 1 == size_ && e < left_.size(); ++e) left_[e] = 0;  // its repetitions go with it
    transit_[element] = std::numeric_limits<double>::infinity();
}

bool ElementBlocks::whole(std::size_t b) const
{
    return std::all_of(&left_[b * lane_count], &left_[b * lane_count] + lane_count, [](double left) { return left != 0; });
}

bool ElementBlocks::gone(std::size_t b) const
{
    return std::none_of(&left_[b * lane_count], &left_[b * lane_count] + lane_count, [](double left) { return left != 0; });
}

void ElementBlocks::set_transit(std::size_t b, const Lanes& transit)
{
    store_lanes(transit, &transit_[b * lane_count]);
    for (std::size_t e = b * lane_count; e < (b + 1) * lane_count; ++e)
        if (left_[e] == 0) transit_[e] = std::numeric_limits<double>::infinity();
}

std::size_t ElementBlocks::review()
{
    stable_step_ = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < size_; ++e) {
        if (!(transit_[e] > 0)) return e;
        stable_step_ = std::min(stable_step_, transit_[e]);
    }
    return size_;
}

std::vector<Field> ElementBlocks::state(const std::string& prefix, const std::string& noun)
{
    const std::size_t each = static_cast<std::size_t>(slots_) + 2;
    Field field{prefix + noun, "1", "what each element keeps, whether it is left, its transit", Scalar::float64, 1, size_ * each, {}, {}};
    field.gather = [this, each](void* out) {
        double* to = static_cast<double*>(out);
        for (std::size_t e = 0; e < size_; ++e, to += each) {
            for (int s = 0; s < slots_; ++s) to[s] = slot(e, s);
            to[slots_] = left_[e];
            to[slots_ + 1] = transit_[e];
        }
    };
    field.restore = [this, each](const void* in, std::size_t count) {
        if (count != size_ * each)
            throw InputError("the saved state has other elements than this model", "resume with the case it was saved from");
        for (std::size_t e = 0; e < left_.size(); ++e) {
            const double* from = static_cast<const double*>(in) + std::min(e, size_ - 1) * each;
            for (int s = 0; s < slots_; ++s) set_slot(e, s, from[s]);
            left_[e] = from[slots_];
            transit_[e] = from[slots_ + 1];
        }
        review();
    };
    return {std::move(field)};
}

}  // namespace corpuscle
