//! Symmetric 3 × 3 matrices.

/// A matrix by its rows.
pub(super) type Matrix = [[f64; 3]; 3];

/// A vector.
pub(super) type Vector = [f64; 3];

/// The unit matrix.
pub(super) const UNIT: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Turns of all three pairs that surely suffice: each makes the rest beside the diagonal quadratically smaller.
const SWEEPS: usize = 16;

/// The eigenvalues of a symmetric matrix, and a unit eigenvector for each, by Jacobi's method.
///
/// Only + − × ÷ √ are used, so that the bits are the same everywhere.
pub(super) fn eigen(matrix: &Matrix) -> (Vector, [Vector; 3]) {
    let mut a = *matrix;
    // The eigenvectors are the rows.
    let mut v = UNIT;
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let half = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let root = (half * half + 1.0).sqrt();
            let tangent = if half < 0.0 { 1.0 / (half - root) } else { 1.0 / (half + root) };
            let cos = 1.0 / (tangent * tangent + 1.0).sqrt();
            let sin = tangent * cos;
            for row in &mut a {
                (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
            }
            for k in 0..3 {
                (a[p][k], a[q][k]) = (cos * a[p][k] - sin * a[q][k], sin * a[p][k] + cos * a[q][k]);
                (v[p][k], v[q][k]) = (cos * v[p][k] - sin * v[q][k], sin * v[p][k] + cos * v[q][k]);
            }
            (a[p][q], a[q][p]) = (0.0, 0.0);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], v)
}

/// Σ w_i v_i v_iᵀ x over these pairs of a number and a vector.
pub(super) fn spectral(weights: Vector, vectors: &[Vector; 3], x: Vector) -> Vector {
    let along = [0, 1, 2].map(|i| weights[i] * dot(vectors[i], x));
    [0, 1, 2]
        .map(|j| along[0] * vectors[0][j] + along[1] * vectors[1][j] + along[2] * vectors[2][j])
}

/// aᵀb
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a + factor · b
pub(super) fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    [0, 1, 2].map(|j| a[j] + factor * b[j])
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};

    use super::*;

    #[test]
    fn a_matrix_is_the_sum_of_its_eigenvectors_times_their_eigenvalues() {
        let mut rng = rand::rngs::Xoshiro256PlusPlus::seed_from_u64(1);
        for _ in 0..1000 {
            let scale = [1e-8, 1.0, 1e8][rng.random_range(0..3_u32) as usize];
            let mut draw = || scale * (2.0 * rng.random::<f64>() - 1.0);
            let [a, b, c, d, e, f] = [0; 6].map(|_| draw());
            let matrix = [[a, b, c], [b, d, e], [c, e, f]];
            let (values, vectors) = eigen(&matrix);
            for j in 0..3 {
                let column = spectral(values, &vectors, UNIT[j]);
                for k in 0..3 {
                    assert!((column[k] - matrix[j][k]).abs() < 1e-13 * scale);
                    assert!((dot(vectors[j], vectors[k]) - UNIT[j][k]).abs() < 1e-13);
                }
            }
        }
    }
}
