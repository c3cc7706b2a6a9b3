// Fields that the parts of a scene file share, and those of its sheets.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "description/scene_description.h"
#include "files/json_fields.h"
#include "world/angles.h"

namespace drench::demo {

using files::FieldReader;
using files::FieldWriter;
using files::Names;
using files::Range;
using files::shown;

inline constexpr Range positionRange{-1e4, 1e4};  // m
inline constexpr Range directions{-1e6, 1e6};     // for vectors whose length is irrelevant
inline constexpr Range unitRange{0, 1};
inline constexpr Range speeds{-1e3, 1e3};  // m/s
inline constexpr double minDirection = 1e-6;
inline constexpr double maxNodes = 2.5e5;  // total of all sheets

// Without the spurious digits of a single-precision number.
inline double widened(float value) {
    constexpr double digits = 1e6;
    return std::round(double(value) * digits) / digits;
}

// An angle that is stored in degrees.
template <typename Fields, typename Number>
void angle(Fields& fields, const std::string& key, Number& value, const Range& range) {
    double inDegrees = degrees(double(value));
    if (std::is_same_v<Number, float>) inDegrees = widened(float(inDegrees));
    fields.number(key, inDegrees, range);
    if constexpr (Fields::reads) value = Number(radians(inDegrees));
}

template <typename Fields>
void floatVector(Fields& fields, const std::string& key, Eigen::Vector3f& value, const Range& range) {
    Eigen::Vector3d wide(widened(value.x()), widened(value.y()), widened(value.z()));
    fields.vector(key, wide, range);
    if constexpr (Fields::reads) value = wide.cast<float>();
}

template <typename Fields, typename Value>
void optionalChoice(Fields& fields, const std::string& key, std::optional<Value>& value,
                    const Names<Value>& names) {
    if constexpr (Fields::reads) {
        if (fields.any(key)) fields.choice(key, value.emplace(), names);
    } else if (value) {
        fields.choice(key, *value, names);
    }
}

// Reads a sheet. @throws std::invalid_argument as `files::FieldReader`
void exchangeSheet(files::FieldReader& fields, SheetDescription& sheet);

// Writes a sheet.
void exchangeSheet(files::FieldWriter& fields, SheetDescription& sheet);

}  // namespace drench::demo
