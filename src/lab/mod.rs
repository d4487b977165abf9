//! Lab: what accuracy farop has, and what more of it would cost.
//!
//! oracle, render -LAB-> figures
//!
//! Why a room of its own: tests say *that* something holds, on cases small enough for every commit; the lab says *how well*, with
//! counts large enough to mean something, and anybody can run it again by name.

pub mod check;
