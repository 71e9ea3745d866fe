#include "fields/field.hpp"

namespace corpuscle {

std::size_t size_of(Scalar scalar)
{
    switch (scalar) {
        case Scalar::uint8: return 1;
        case Scalar::float32:
        case Scalar::int32:
        case Scalar::uint32: return 4;
        case Scalar::float64:
        case Scalar::uint64: break;
    }
    return 8;
}

const Field* FieldSet::find(const std::string& field_name) const
{
    for (const Field& field : fields) {
        if (field.name == field_name) return &field;
    }
    return nullptr;
}

}  // namespace corpuscle
