#pragma once
/// Settings of threads and memory that libraries read before main.

namespace creepcontact::platform {

/// Sets, unless the user has, that waiting threads of OpenMP sleep (spinning ones take the cores from other programs),
/// and that the BLAS makes no threads before it factors (each reserves 128 MB of address space). The libraries read
/// that as they are loaded, so the program starts again where it must be changed. glibc is told to ask for huge pages:
/// factors of a million pages of 4 kB cost more time to allocate than to read several times.
/// @param arguments  of main
void set_libraries(char** arguments);

}  // namespace creepcontact::platform
