#pragma once

#include <cmath>

namespace corpuscle {

/// Three Cartesian components.
template <class T>
struct Vector3 {
    T x{}, y{}, z{};

    constexpr Vector3() = default;
    constexpr Vector3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    template <class U>
    constexpr explicit Vector3(const Vector3<U>& other) : x(static_cast<T>(other.x)), y(static_cast<T>(other.y)), z(static_cast<T>(other.z))
    {
    }

    constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr const T& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    constexpr Vector3& operator+=(const Vector3& b)
    {
        x += b.x, y += b.y, z += b.z;
        return *this;
    }
    constexpr Vector3& operator-=(const Vector3& b)
    {
        x -= b.x, y -= b.y, z -= b.z;
        return *this;
    }
    constexpr Vector3& operator*=(T s)
    {
        x *= s, y *= s, z *= s;
        return *this;
    }

    friend constexpr Vector3 operator+(Vector3 a, const Vector3& b) { return a += b; }
    friend constexpr Vector3 operator-(Vector3 a, const Vector3& b) { return a -= b; }
    friend constexpr Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vector3 operator*(Vector3 a, T s) { return a *= s; }
    friend constexpr Vector3 operator*(T s, Vector3 a) { return a *= s; }
    friend constexpr Vector3 operator/(Vector3 a, T s) { return a *= (T(1) / s); }
    friend constexpr bool operator==(const Vector3& a, const Vector3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

using Vector3d = Vector3<double>;
using Vector3f = Vector3<float>;

template <class T>
constexpr T dot(const Vector3<T>& a, const Vector3<T>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
constexpr Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Component by component.
template <class T>
constexpr Vector3<T> scaled(const Vector3<T>& a, const Vector3<T>& b)
{
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <class T>
constexpr T norm_squared(const Vector3<T>& a)
{
    return dot(a, a);
}

template <class T>
T norm(const Vector3<T>& a)
{
    return std::sqrt(dot(a, a));
}

template <class T>
Vector3<T> normalized(const Vector3<T>& a)
{
    return a / norm(a);
}

}  // namespace corpuscle
