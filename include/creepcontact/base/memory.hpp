#pragma once
/// State as named arrays of numbers, as checkpoints hold it. A struct lists its members once; the names of the arrays,
/// saving and restoring follow from the list:
///
///   struct Force {
///     double time, value;
///     static constexpr auto members = std::tuple{Member{"time", &Force::time}, Member{"value", &Force::value}};
///   };
///   memory.save("forces", forces);     // a vector of them: writes the arrays forces.time and forces.value
///   memory.restore("forces", forces);
///
/// A list that lacks a member does not compile.

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace creepcontact {

/// A member of a struct and its name in a Memory.
template <typename Owner, typename Value>
struct Member {
  std::string_view name;
  Value Owner::*value;
};
template <typename Owner, typename Value>
Member(std::string_view, Value Owner::*) -> Member<Owner, Value>;

/// The types that a Memory takes: numbers (arithmetic types and enumerations), arrays of them, structs with a list of
/// members, and std::vector and std::optional of all of these.
namespace saved {

template <typename T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <typename T>
concept Record = requires {
  T::members;
};

/// std::vector, std::array, std::string and vectors of Eigen.
template <typename T>
concept Numbers = requires(const T& array) {
  array.size();
  requires Number<std::remove_cvref_t<decltype(*array.data())>>;
};

/// Number of numbers in every value of the type; 0 if it differs among values.
template <typename T>
constexpr std::size_t width() {
  if constexpr (Number<T>) {
    return 1;
  } else if constexpr (Record<T>) {
    return std::apply(
        []<typename... Values>(const Member<T, Values>&... /*member*/) {
          return ((width<Values>() > 0) && ...) ? (width<Values>() + ...) : 0;
        },
        T::members);
  } else if constexpr (requires { T::SizeAtCompileTime; }) {  // of Eigen
    return T::SizeAtCompileTime > 0 ? T::SizeAtCompileTime : 0;
  } else if constexpr (Numbers<T> && requires { std::tuple_size<T>::value; }) {
    return std::tuple_size_v<T>;
  } else {
    return 0;
  }
}

/// Converts to any type, only to count members.
struct AnyMember {
  template <typename T>
  operator T() const;  // NOLINT(google-explicit-constructor): takes the place of any member
};

/// Number of members of a struct without constructors.
template <typename T, std::size_t N = 32>
constexpr std::size_t count_members() {
  constexpr bool fits = []<std::size_t... I>(std::index_sequence<I...>) {
    return requires {
      T{(static_cast<void>(I), AnyMember{})...};
    };
  }
  (std::make_index_sequence<N>{});
  if constexpr (fits)
    return N;
  else
    return count_members<T, N - 1>();
}

template <Record T, typename Function>
void for_each_member(const Function& function) {
  static_assert(std::tuple_size_v<std::remove_const_t<decltype(T::members)>> == count_members<T>(),
                "a member is not in the list");
  std::apply([&](const auto&... member) { (function(member), ...); }, T::members);
}

inline std::string joined(const std::string& name, std::string_view member) {
  return name.empty() ? std::string(member) : fmt::format("{}.{}", name, member);
}

// std::optional has no or one element.
template <typename T>
std::size_t size(const std::vector<T>& values) {
  return values.size();
}
template <typename T>
std::size_t size(const std::optional<T>& value) {
  return value ? 1 : 0;
}
template <typename T>
void resize(std::vector<T>& values, std::size_t size) {
  values.resize(size);
}
template <typename T>
void resize(std::optional<T>& value, std::size_t size) {
  if (size == 0)
    value.reset();
  else
    value = T();  // emplace() takes no aggregate
}
template <typename Container>
auto& element(Container& values, std::size_t i) {
  if constexpr (requires { values[i]; })
    return values[i];
  else
    return *values;
}

template <Number T>
T from_double(double number) {
  if constexpr (std::is_enum_v<T>)
    return static_cast<T>(static_cast<std::underlying_type_t<T>>(number));
  else if constexpr (std::is_same_v<T, bool>)
    return number != 0;
  else
    return static_cast<T>(number);
}

}  // namespace saved

/// Arrays of numbers by name. Integers are exact up to 2^53. Vectors of structs with a fixed number of numbers become
/// one array per member, those of other structs one set of arrays per element.
class Memory : public std::map<std::string, std::vector<double>> {
 public:
  using map::map;

  /// Adds the arrays of a value, whose names begin with `name`; replaces those of the same names.
  template <typename T>
  void save(const std::string& name, const T& value);
  /// Inverse of save(). @throws std::out_of_range naming the array if it is missing or has another size
  template <typename T>
  void restore(const std::string& name, T& value) const;
  /// save() and restore() for some members of an object, such as those of a class that do not follow from the others.
  template <typename T, typename... Values>
  void save(const std::string& name, const T& object, const std::tuple<Member<T, Values>...>& members);
  template <typename T, typename... Values>
  void restore(const std::string& name, T& object, const std::tuple<Member<T, Values>...>& members) const;

  /// Adds arrays of another memory, each as `name.<its name>`. @see part
  void add(const std::string& name, Memory part);
  /// Inverse of add(): the arrays whose names begin with `name.`, named by what follows.
  Memory part(const std::string& name) const;

 private:
  /// Arrays with the numbers of n elements. @param element  gives a reference to the element of an index
  template <typename T, typename Element>
  void save_elements(const std::string& name, std::size_t n, const Element& element);
  template <typename T, typename Element>
  void restore_elements(const std::string& name, std::size_t n, const Element& element) const;
  /// Number of elements that save_elements() has saved.
  template <typename T>
  std::size_t n_elements(const std::string& name) const;
  /// @throws std::out_of_range if it is missing
  const std::vector<double>& array(const std::string& name) const;
  /// @throws std::out_of_range if it is missing or has another size
  const std::vector<double>& array(const std::string& name, std::size_t size) const;
};

template <typename T>
void Memory::save(const std::string& name, const T& value) {
  if constexpr (saved::width<T>() > 0) {
    save_elements<T>(name, 1, [&](std::size_t) -> const T& { return value; });
  } else if constexpr (saved::Numbers<T>) {
    save_elements<typename T::value_type>(
        name, static_cast<std::size_t>(value.size()), [&](std::size_t i) -> const auto& { return value.data()[i]; });
  } else if constexpr (saved::Record<T>) {
    saved::for_each_member<T>([&](const auto& member) { save(saved::joined(name, member.name), value.*member.value); });
  } else {
    using Element = typename T::value_type;
    const std::size_t n = saved::size(value);
    const auto element = [&](std::size_t i) -> const Element& { return saved::element(value, i); };
    if constexpr (saved::width<Element>() > 0) {
      save_elements<Element>(name, n, element);
    } else {
      save(name, n);
      for (std::size_t i = 0; i < n; ++i) save(saved::joined(name, std::to_string(i)), element(i));
    }
  }
}

template <typename T>
void Memory::restore(const std::string& name, T& value) const {
  if constexpr (saved::width<T>() > 0) {
    restore_elements<T>(name, 1, [&](std::size_t) -> T& { return value; });
  } else if constexpr (saved::Numbers<T>) {
    const std::size_t n = array(name).size();
    value.resize(n);
    restore_elements<typename T::value_type>(
        name, n, [&](std::size_t i) -> auto& { return value.data()[i]; });
  } else if constexpr (saved::Record<T>) {
    saved::for_each_member<T>(
        [&](const auto& member) { restore(saved::joined(name, member.name), value.*member.value); });
  } else {
    using Element = typename T::value_type;
    const auto element = [&](std::size_t i) -> Element& { return saved::element(value, i); };
    if constexpr (saved::width<Element>() > 0) {
      const std::size_t n = n_elements<Element>(name);
      saved::resize(value, n);
      restore_elements<Element>(name, n, element);
    } else {
      std::size_t n = 0;
      restore(name, n);
      saved::resize(value, n);
      for (std::size_t i = 0; i < n; ++i) restore(saved::joined(name, std::to_string(i)), element(i));
    }
  }
}

template <typename T, typename... Values>
void Memory::save(const std::string& name, const T& object, const std::tuple<Member<T, Values>...>& members) {
  std::apply([&](const auto&... member) { (save(saved::joined(name, member.name), object.*member.value), ...); },
             members);
}

template <typename T, typename... Values>
void Memory::restore(const std::string& name, T& object, const std::tuple<Member<T, Values>...>& members) const {
  std::apply([&](const auto&... member) { (restore(saved::joined(name, member.name), object.*member.value), ...); },
             members);
}

inline void Memory::add(const std::string& name, Memory part) {
  for (auto& entry : part) (*this)[saved::joined(name, entry.first)] = std::move(entry.second);
}

inline Memory Memory::part(const std::string& name) const {
  const std::string prefix = saved::joined(name, "");
  Memory part;
  for (auto found = lower_bound(prefix); found != end() && found->first.starts_with(prefix); ++found)
    part[found->first.substr(prefix.size())] = found->second;
  return part;
}

template <typename T, typename Element>
void Memory::save_elements(const std::string& name, std::size_t n, const Element& element) {
  if constexpr (saved::Record<T>) {
    saved::for_each_member<T>([&]<typename Value>(const Member<T, Value>& member) {
      save_elements<Value>(saved::joined(name, member.name), n,
                           [&](std::size_t i) -> const Value& { return element(i).*member.value; });
    });
  } else {
    std::vector<double>& numbers = (*this)[name];
    numbers.clear();
    numbers.reserve(n * saved::width<T>());
    for (std::size_t i = 0; i < n; ++i)
      if constexpr (saved::Number<T>)
        numbers.push_back(static_cast<double>(element(i)));
      else
        for (const auto& number : element(i)) numbers.push_back(static_cast<double>(number));
  }
}

template <typename T, typename Element>
void Memory::restore_elements(const std::string& name, std::size_t n, const Element& element) const {
  if constexpr (saved::Record<T>) {
    saved::for_each_member<T>([&]<typename Value>(const Member<T, Value>& member) {
      restore_elements<Value>(saved::joined(name, member.name), n,
                              [&](std::size_t i) -> Value& { return element(i).*member.value; });
    });
  } else {
    const double* next = array(name, n * saved::width<T>()).data();
    for (std::size_t i = 0; i < n; ++i)
      if constexpr (saved::Number<T>)
        element(i) = saved::from_double<T>(*next++);
      else
        for (auto& number : element(i)) number = saved::from_double<std::remove_reference_t<decltype(number)>>(*next++);
  }
}

template <typename T>
std::size_t Memory::n_elements(const std::string& name) const {
  if constexpr (saved::Record<T>) {
    return [&]<typename Value>(const Member<T, Value>& first) {
      return n_elements<Value>(saved::joined(name, first.name));
    }(std::get<0>(T::members));
  } else {
    return array(name).size() / saved::width<T>();
  }
}

}  // namespace creepcontact
