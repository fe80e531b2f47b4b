using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Springs;

/// <summary>
/// The exact solution of the damped oscillator x'' = a − ω²x − 2ζω·x' over a substep h. With (ωh)² = K and 2ζωh = G
/// <para>v₁ = (1 − K·Second − G·First)·v − (K/h)·First·x + First·a·h,</para>
/// <para>x₁ = (1 − K·Second)·x + h·First·v + Second·a·h².</para>
/// Frequency, damping and the rest at x = a/ω² are those of the continuous spring at every h. The plain implicit form gives
/// 10.4 Hz and ζ = 0.62 for 20 Hz and ζ = 0.05 at h = 1/60.
/// </summary>
internal struct SpringLaw
{
    /// <summary>
    /// Above this angle a substep samples the oscillation less than twice a period: its frequency is no longer to be had.
    /// </summary>
    private const double LargestTurn = 3.0;

    private const double SeriesLimit = 1e-5;

    /// <summary>Below this (ωh)² the spring changes the coefficients by less than the last digit that is left of them.</summary>
    private const double WeakLimit = 1e-7;

    public double Stiffness;
    public double Damping;

    /// <summary>What a velocity of 1 becomes as a way, over h; what a load does to the velocity.</summary>
    public double First;

    /// <summary>What a load does to the way.</summary>
    public double Second;

    /// <param name="stiffness">(ωh)² = k·h²/m, 0 or more.</param>
    /// <param name="damping">2ζωh = c·h/m, 0 or more.</param>
    public SpringLaw(double stiffness, double damping)
    {
        Stiffness = stiffness;
        Damping = damping;
        double half = damping / 2;
        double discriminant = (half * half) - stiffness;
        if (stiffness < WeakLimit)
        {
            var drag = new DragLaw(damping, 1);
            First = drag.First;
            Second = drag.Second;
        }
        else if (discriminant > SeriesLimit)
        {
            // Rates half ± s; the slow one from the product of both, since the difference loses its digits.
            double s = Math.Sqrt(discriminant);
            double fast = half + s;
            double slow = stiffness / fast;
            First = (OneMinusExp(fast) - OneMinusExp(slow)) / (2 * s);
            Second = ((fast * OneMinusExp(slow)) - (slow * OneMinusExp(fast))) / (2 * s * stiffness);
        }
        else
        {
            double decay = StableMath.Exp(-half);
            double cos = 1 + (discriminant / 2 * (1 + (discriminant / 12 * (1 + (discriminant / 30)))));
            double sinc = 1 + (discriminant / 6 * (1 + (discriminant / 20 * (1 + (discriminant / 42)))));
            if (discriminant < -SeriesLimit)
            {
                double turn = Math.Sqrt(-discriminant);
                StableMath.SinCos(turn, out double sin, out cos);
                sinc = sin / turn;
            }

            First = decay * sinc;
            Second = (1 - (decay * (cos + (half * sinc)))) / stiffness;
        }
    }

    /// <summary>True if an oscillation of these numbers turns by no more than <see cref="LargestTurn"/> in a substep.</summary>
    public static bool IsResolved(double stiffness, double damping) =>
        stiffness - (damping * damping / 4) <= LargestTurn * LargestTurn;

    /// <summary>Change of the velocity in the substep, from x, v and the change a·h that the load makes by itself.</summary>
    public double Change(double x, double v, double drive, double h) =>
        -(((Stiffness * Second) + (Damping * First)) * v) - (Stiffness / h * First * x) + (First * drive);

    /// <summary>Change of x in the substep.</summary>
    public double Way(double x, double v, double drive, double h) =>
        (h * First * v) - (Stiffness * Second * x) + (h * Second * drive);

    private static double OneMinusExp(double x) =>
        x < SeriesLimit ? x * (1 - (x / 2 * (1 - (x / 3)))) : 1 - StableMath.Exp(-x);
}
