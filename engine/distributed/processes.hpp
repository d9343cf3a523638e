// SPDX-License-Identifier: GPL-2.0-only
/// The processes of a run, and what they say to each other besides the soil.
#pragma once

#include <mpi.h>

#include <span>
#include <vector>

#include "engine/distributed/message.hpp"

namespace scarp::distributed {

/// All members are called by all processes together. The first process leads.
class Processes {
 public:
  /// Begins MPI, and ends it.
  Processes(int& argc, char**& argv);
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }
  bool leads() const { return rank_ == 0; }
  MPI_Comm communicator() const { return communicator_; }

  enum class Join { nothing, maximum, minimum, sum };
  /// Joins values element by element, in the order of the processes: the same bits each time. A
  /// maximum or minimum with a NaN is NaN. `failed`: this process gives no values and takes none.
  /// Returns whether any has failed; the values then mean nothing.
  bool join(Join how, std::span<double> values, bool failed = false);
  /// Appends the values of the other processes in the order of their numbers; `to_all`: in each,
  /// else in the leading one, which has its own first.
  void gather(std::vector<double>& values, bool to_all);
  /// What the process `from` has.
  Message broadcast(const Message& message, int from = 0);
  /// Ends all processes at once, with this exit code.
  [[noreturn]] void end_all(int code);

 private:
  MPI_Comm communicator_ = MPI_COMM_NULL;
  MPI_Datatype packet_type_ = MPI_DATATYPE_NULL;
  MPI_Op join_packets_ = MPI_OP_NULL;
  int rank_ = 0, count_ = 1;
};

}  // namespace scarp::distributed
