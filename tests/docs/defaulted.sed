# What the language defines of itself says so in the pages, and not in every header.
s|^( *)((constexpr )?bool operator==\(.*\) const = default;)|\1/** True if all members are the same. */ \2|
s|^( *)([A-Za-z]+\([A-Za-z]+&&( other)?\) noexcept;)|\1/** Takes over what the other held, which may then only be destroyed or assigned to. */ \2|
s|^( *)([A-Za-z]+& operator=\([A-Za-z]+&&( other)?\) noexcept;)|\1/** Takes over what the other held, which may then only be destroyed or assigned to. */ \2|
