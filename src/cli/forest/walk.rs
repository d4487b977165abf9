//! Where a walk leads.
