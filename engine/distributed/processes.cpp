// SPDX-License-Identifier: GPL-2.0-only
/// MPI.
#include "engine/distributed/processes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp::distributed {
namespace {

using Join = Processes::Join;

/// One message for a join of a few values and for the word that a process has failed, which does
/// not know what the others are about to join.
struct Packet {
  static constexpr std::size_t most = 13;
  double failed = 0.0;
  double how = 0.0;
  double count = 0.0;
  std::array<double, most> values{};
};
constexpr int packet_length = sizeof(Packet) / sizeof(double);

double joined(Join how, double a, double b) {
  switch (how) {
    case Join::maximum:
      return std::isnan(a) ? a : (b > a || std::isnan(b) ? b : a);
    case Join::minimum:
      return std::isnan(a) ? a : (b < a || std::isnan(b) ? b : a);
    case Join::sum:
      return a + b;
    case Join::nothing:
      break;
  }
  return a;
}

/// `in` belongs to processes before those of `in_out`.
void join_packets(void* in, void* in_out, int* length, MPI_Datatype*) {
  const auto* before = static_cast<const Packet*>(in);
  auto* after = static_cast<Packet*>(in_out);
  for (int k = 0; k < *length; ++k) {
    const Packet& a = before[k];
    Packet& b = after[k];
    b.failed = std::max(a.failed, b.failed);
    if (b.failed != 0.0) continue;
    for (std::size_t v = 0; v < static_cast<std::size_t>(b.count); ++v)
      b.values[v] = joined(static_cast<Join>(static_cast<int>(b.how)), a.values[v], b.values[v]);
  }
}

}  // namespace

Processes::Processes(int& argc, char**& argv) {
  int offered = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &offered);
  MPI_Comm_dup(MPI_COMM_WORLD, &communicator_);
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &count_);
  MPI_Type_contiguous(packet_length, MPI_DOUBLE, &packet_type_);
  MPI_Type_commit(&packet_type_);
  MPI_Op_create(join_packets, 0, &join_packets_);
}

Processes::~Processes() {
  MPI_Op_free(&join_packets_);
  MPI_Type_free(&packet_type_);
  MPI_Comm_free(&communicator_);
  MPI_Finalize();
}

bool Processes::join(Join how, std::span<double> values, bool failed) {
  if (count_ == 1) return failed;
  std::size_t done = 0;
  do {
    const std::size_t count = std::min(values.size() - done, Packet::most);
    Packet packet{failed ? 1.0 : 0.0, static_cast<double>(how), static_cast<double>(count), {}};
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(done), count, packet.values.begin());
    MPI_Allreduce(MPI_IN_PLACE, &packet, 1, packet_type_, join_packets_, communicator_);
    if (packet.failed != 0.0) return true;
    std::copy_n(packet.values.begin(), count, values.begin() + static_cast<std::ptrdiff_t>(done));
    done += count;
  } while (done < values.size());
  return false;
}

void Processes::gather(std::vector<double>& values, bool to_all) {
  if (count_ == 1) return;
  std::array<double, 1> sum{static_cast<double>(values.size())};
  join(Join::sum, sum);
  if (sum[0] > std::numeric_limits<int>::max()) {
    throw Error(fmt::format(
        "the first process is to gather {:.0f} numbers at once, and MPI counts to 2^31. Try "
        "a scene without frames and checkpoints, or fewer particles.",
        sum[0]));
  }
  const auto own = static_cast<int>(values.size());
  std::vector<int> counts(static_cast<std::size_t>(count_)), first(counts.size());
  MPI_Allgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator_);
  std::exclusive_scan(counts.begin(), counts.end(), first.begin(), 0);
  std::vector<double> all(to_all || leads() ? static_cast<std::size_t>(first.back()) +
                                                  static_cast<std::size_t>(counts.back())
                                            : 0);
  if (to_all) {
    MPI_Allgatherv(values.data(), own, MPI_DOUBLE, all.data(), counts.data(), first.data(),
                   MPI_DOUBLE, communicator_);
    const auto mine = all.begin() + first[static_cast<std::size_t>(rank_)];
    all.erase(mine, mine + own);
    values.insert(values.end(), all.begin(), all.end());
    return;
  }
  MPI_Gatherv(values.data(), own, MPI_DOUBLE, all.data(), counts.data(), first.data(), MPI_DOUBLE,
              0, communicator_);
  if (leads()) values = std::move(all);
}

Message Processes::broadcast(const Message& message, int from) {
  if (count_ == 1) return message;
  std::vector<char> bytes = rank_ == from ? message.bytes() : std::vector<char>{};
  std::size_t size = bytes.size();
  MPI_Bcast(&size, sizeof size, MPI_BYTE, from, communicator_);
  bytes.resize(size);
  constexpr std::size_t most = std::size_t{1} << 30;  // MPI counts with an int
  for (std::size_t done = 0; done < size; done += most)
    MPI_Bcast(bytes.data() + done, static_cast<int>(std::min(most, size - done)), MPI_BYTE, from,
              communicator_);
  return Message(std::move(bytes));
}

void Processes::end_all(int code) {
  MPI_Abort(communicator_, code);
  std::abort();
}

}  // namespace scarp::distributed
