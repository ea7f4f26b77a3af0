//! The hash of a history.

use crate::search::GenerationRecord;

/// FNV-1a, 64 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hash(u64);

impl Hash {
    /// 16 hexadecimal digits.
    pub(super) fn digits(self) -> String {
        format!("{:016x}", self.0)
    }

    pub(super) const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    fn word(&mut self, word: u64) {
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        // A byte of zero only multiplies, so that the zeros at the end of a small number are one multiplication.
        let zeros = word.leading_zeros() / 8;
        for byte in &word.to_le_bytes()[..8 - zeros as usize] {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
        self.0 = self.0.wrapping_mul(PRIME.wrapping_pow(zeros));
    }

    fn number(&mut self, number: f64) {
        // The bits of NaN are the machine's choice, so all count as one.
        const NAN: u64 = 0x7ff8_0000_0000_0000;
        self.word(if number.is_nan() { NAN } else { number.to_bits() });
    }

    pub(super) fn record(&mut self, record: &GenerationRecord) {
        self.word(record.generation.into());
        for individual in record.parents.iter().chain(&record.offspring) {
            let numbers = individual.gains.to_array().into_iter().chain(individual.sigmas);
            numbers.for_each(|number| self.number(number));
            self.number(individual.cost);
        }
        let opponents = record.tournament.opponents.iter().flatten();
        for number in opponents.chain(&record.tournament.wins).chain(&record.survivors) {
            self.word((*number).into());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Hash;

    #[test]
    fn every_nan_is_one_number_and_the_two_zeros_are_two() {
        let of = |bits| {
            let mut hash = Hash::EMPTY;
            hash.number(f64::from_bits(bits));
            hash.digits()
        };
        assert_eq!(of(0xfff8_0000_0000_0000), of(0x7ff8_0000_0000_0001));
        assert_ne!(of(0.0_f64.to_bits()), of((-0.0_f64).to_bits()));
    }
}
