#pragma once
/// Bytes as text (RFC 4648).

#include <optional>
#include <string>
#include <string_view>

namespace creepcontact {

std::string base64(std::string_view bytes);
/// @returns nullopt if the text is not what base64() makes
std::optional<std::string> from_base64(std::string_view text);
/// "data:image/png;base64,..." @param type  "image/png"
std::string data_url(std::string_view type, std::string_view bytes);

}  // namespace creepcontact
