#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "cli/command_line.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "realize/exact/memory.hpp"

namespace {

using hexatlas::cli::ExitCode;
using hexatlas::cli::say;
using hexatlas::cli::say_fault;

/// A file opened while a standard stream is closed would get its number and receive its text.
/// Each closed one is taken by a descriptor on which its use fails as on a closed one.
void occupy_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) == -1 && errno == EBADF)
      static_cast<void>(::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

/// Errors become one line and a documented exit code; see docs/architecture/README.md.
ExitCode run(int argc, char** argv) {
  try {
    return hexatlas::cli::run_command_line(argc, argv);
  } catch (const hexatlas::core::InvalidInput& error) {
    say_fault(error.what());
    return ExitCode::invalid_input;
  } catch (const hexatlas::core::ResourceFailure& error) {
    say(error.what());
    return ExitCode::resources;
  } catch (const std::bad_alloc&) {
    say("out of memory");
    return ExitCode::resources;
  } catch (const std::exception& error) {
    say(std::string("internal error, please report it: ") + error.what());
    return ExitCode::internal;
  }
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that gets too large is an error of writing, not the end
  hexatlas::exact::throw_when_out_of_memory();
  return static_cast<int>(run(argc, argv));
}
