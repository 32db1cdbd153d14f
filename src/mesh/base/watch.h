#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace swathplan {

/// Looks on at long work, and may end it. One thread at a time tells it something; any may ask.
class Watcher {
 public:
  Watcher() = default;
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;
  virtual ~Watcher() = default;

  /// What is done from now on, in a few words.
  virtual void phase(const std::string& what) = 0;
  /// How much of the phase is done, [0, 1].
  virtual void share(double done) = 0;
  /// How many candidates were tried, of about how many (0: nobody knows), and the best so far.
  virtual void tried(std::size_t count, std::size_t of, const std::string& best) = 0;
  /// Whether a search is to end and to keep the best that it has finished. Stays true.
  [[nodiscard]] virtual bool ended() const = 0;
};

/// A watcher, which must outlive it, or nobody. No result depends on a watcher that never ends the
/// work. A search that is ended after k candidates gives the same result each time.
class Watch {
 public:
  Watch() = default;
  explicit Watch(Watcher& watcher) : watcher_(&watcher) {}

  void phase(const std::string& what) const {
    if (watcher_ != nullptr) watcher_->phase(what);
  }
  void share(double done) const {
    if (watcher_ != nullptr) watcher_->share(done);
  }
  void tried(std::size_t count, std::size_t of, const std::string& best) const {
    if (watcher_ != nullptr) watcher_->tried(count, of, best);
  }
  [[nodiscard]] bool ended() const { return watcher_ != nullptr && watcher_->ended(); }

 private:
  Watcher* watcher_ = nullptr;
};

/// The work was ended before it had a result. It says what is kept and how to go on.
class EndedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace swathplan
