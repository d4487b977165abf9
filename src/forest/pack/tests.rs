//! Packs: what comes back, what is lost, and what happens to broken ones.
