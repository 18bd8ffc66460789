#include "standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <iostream>

namespace creepcontact::cli {

StandardOutput::StandardOutput() : before_(std::cout.rdbuf(this)) {
  std::signal(SIGPIPE, SIG_IGN);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    // The lowest free number is this one.
    if (::fcntl(descriptor, F_GETFD) == -1 && errno == EBADF) ::open("/dev/null", O_RDWR);
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

StandardOutput::~StandardOutput() {
  write();
  std::cout.rdbuf(before_);
}

int StandardOutput::finish() {
  write();
  return error_ == EPIPE ? 0 : error_;
}

StandardOutput::int_type StandardOutput::overflow(int_type letter) {
  write();
  if (!traits_type::eq_int_type(letter, traits_type::eof())) sputc(traits_type::to_char_type(letter));
  return traits_type::not_eof(letter);
}

int StandardOutput::sync() {
  write();
  return 0;
}

void StandardOutput::write() {
  for (const char* text = pbase(); text < pptr() && error_ == 0;) {
    const ssize_t written = ::write(STDOUT_FILENO, text, pptr() - text);
    if (written >= 0)
      text += written;
    else if (errno != EINTR)
      error_ = errno;
  }
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

}  // namespace creepcontact::cli
