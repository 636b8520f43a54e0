//! Why a certificate proves nothing.

/// Why a certificate proves nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CertificateFault {
    /// The bound that the certificate is of, by flows, by shares, by walks or by stops, does not apply to the problem.
    #[error("The problem has no bound of the kind that the certificate is of.")]
    Problem,
    /// A list has another length than the problem asks for, or names an item that is not there.
    #[error("The {0} of the certificate do not fit the problem.")]
    Shape(&'static str),
    /// The check would take too long, or too much memory.
    #[error("The certificate has more {0} than are checked.")]
    TooMuch(&'static str),
    /// A leg or a stop costs less than the numbers make it pay.
    #[error("In the certificate, a {0} costs less than it pays.")]
    Overpaid(&'static str),
    /// The numbers prove another bound than the certificate states.
    #[error("The certificate states a bound of {stated} units, but its numbers prove {proven}.")]
    Bound {
        /// The stated bound, in units.
        stated: i64,
        /// What follows from the numbers, in units.
        proven: i128,
    },
}
