#include "death.hpp"

#include <unistd.h>

#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include "creepcontact/io/msh/mesher_protocol.hpp"

/// Gmsh's own, declared in none of its installed headers; weak: absent in versions that hide them.
extern std::string gmsh_yyname [[gnu::weak]];
extern int gmsh_yylineno [[gnu::weak]];

namespace creepcontact::mesher {
namespace {

bool is_reading = false;

void write_all(const char* text, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(STDERR_FILENO, text, size);
    if (written <= 0) return;
    text += written;
    size -= static_cast<std::size_t>(written);
  }
}

void write_text(const char* text) {
  write_all(text, std::strlen(text));
}

extern "C" void tell_place_and_die(int signal) {
  report_place();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

void tell_of_exit() {
  report_line("the file ended Gmsh");
  report_place();
  _exit(io::mesher::ended_by_file);
}

}  // namespace

void report_line(const char* text) {
  write_text("\n");
  write_text(io::mesher::mark);
  write_text(text);
  write_text("\n");
}

void report_place() {
  if (!is_reading || &gmsh_yyname == nullptr || &gmsh_yylineno == nullptr) return;
  write_text("\n");
  write_text(io::mesher::mark);
  write_text("at ");
  write_all(gmsh_yyname.data(), gmsh_yyname.size());
  write_text(", line ");
  std::array<char, 12> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), gmsh_yylineno - 1).ptr;
  write_all(digits.data(), end - digits.data());
  write_text("\n");
}

void watch() {
  is_reading = true;
  static std::array<char, 1 << 16> stack;  // the usual one may be what ran out
  const stack_t other{stack.data(), 0, stack.size()};
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = tell_place_and_die;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
  for (int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
  std::atexit(tell_of_exit);
}

void stop_reading() {
  is_reading = false;
}

void exit_at_once(int status) {
  _exit(status);
}

}  // namespace creepcontact::mesher
