using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The points of a bundle's contacts with the arms of one moment. An impact sees velocities and gives impulses at the same arms, those of
/// its moment: then an impulse x with x·(v + v') ≤ 0, v and v' being the velocities of its point before and after, takes the energy -x·(v +
/// v')/2 and never adds any, whatever the shape and the spin.
/// </summary>
internal unsafe ref struct ImpactArms
{
    /// <summary>Below this share of k11·k22 the determinant is noise and the points are solved row by row.</summary>
    private const float DeterminantShare = 1e-3f;

    private readonly ContactBundle* _row;
    private readonly int _lane;
    private readonly Wide _armA0;
    private readonly Wide _armB0;
    private readonly Wide _armA1;
    private readonly Wide _armB1;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public ImpactArms(ContactBundle* row, int lane, in WideDelta a, in WideDelta b)
    {
        _row = row;
        _lane = lane;
        _armA0 = Across(row->Point0.TangentArmA, row->Point0.NormalArmA, lane, a);
        _armB0 = Across(row->Point0.TangentArmB, row->Point0.NormalArmB, lane, b);
        _armA1 = Across(row->Point1.TangentArmA, row->Point1.NormalArmA, lane, a);
        _armB1 = Across(row->Point1.TangentArmB, row->Point1.NormalArmB, lane, b);
    }

    /// <summary>How fast the surfaces of both points part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Velocities(in WideVelocity a, in WideVelocity b, out Wide v0, out Wide v1)
    {
        Wide un = (Wide.Load(_row->NormalX + _lane) * (b.X - a.X)) + (Wide.Load(_row->NormalY + _lane) * (b.Y - a.Y));
        v0 = un + ((b.W * _armB0) - (a.W * _armA0));
        v1 = un + ((b.W * _armB1) - (a.W * _armA1));
    }

    /// <summary>
    /// The impulses x ≥ 0 with which the points that are struck part as they should, K(x - y) + r ≥ 0; the others, and those that do not
    /// answer, get none.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Solve(WideMask struck0, WideMask struck1, Wide y0, Wide y1, Wide r0, Wide r1, out Wide x0, out Wide x1)
    {
        Wide iA = Wide.Load(_row->InertiaA + _lane);
        Wide iB = Wide.Load(_row->InertiaB + _lane);
        Wide m = Wide.Load(_row->MassA + _lane) + Wide.Load(_row->MassB + _lane);
        Wide k11 = m + (iA * _armA0 * _armA0) + (iB * _armB0 * _armB0);
        Wide k22 = m + (iA * _armA1 * _armA1) + (iB * _armB1 * _armB1);
        struck0 = struck0 & (k11 > Wide.Zero);
        struck1 = struck1 & (k22 > Wide.Zero);
        k11 = Wide.Select(struck0, k11, Wide.One);
        k22 = Wide.Select(struck1, k22, Wide.One);
        Wide k12 = Wide.Keep(struck0 & struck1, m + (iA * _armA0 * _armA1) + (iB * _armB0 * _armB1));
        WideMask block = ((k11 * k22) - (k12 * k12)) > (Wide.Splat(DeterminantShare) * k11 * k22);
        r0 = Wide.Select(struck0, r0, Wide.One);
        r1 = Wide.Select(struck1, r1, Wide.One);
        var responses = new PointResponses(k11, k22, k12, block);
        ContactKernel.SolveResponses(responses, y0, y1, r0, r1, out x0, out x1);
    }

    /// <summary>What two normal impulses change the velocities of both bodies by.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Push(Wide p0, Wide p1, out WideVelocity a, out WideVelocity b)
    {
        Wide px = Wide.Load(_row->NormalX + _lane) * (p0 + p1);
        Wide py = Wide.Load(_row->NormalY + _lane) * (p0 + p1);
        a.X = Wide.Zero - (Wide.Load(_row->MassA + _lane) * px);
        a.Y = Wide.Zero - (Wide.Load(_row->MassA + _lane) * py);
        b.X = Wide.Load(_row->MassB + _lane) * px;
        b.Y = Wide.Load(_row->MassB + _lane) * py;
        a.W = Wide.Zero - (Wide.Load(_row->InertiaA + _lane) * ((_armA0 * p0) + (_armA1 * p1)));
        b.W = Wide.Load(_row->InertiaB + _lane) * ((_armB0 * p0) + (_armB1 * p1));
    }

    /// <summary>
    /// Friction of a point within the cone of the impact's own normal impulse, at the arms of the surfaces. It ends a slip and never
    /// reverses it, so it takes energy as well.
    /// </summary>
    /// <returns>The tangential impulse of the impact.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Wide Rub(
        ContactPointLanes* point,
        in WideDelta movedA,
        in WideDelta movedB,
        Wide normal,
        Wide before,
        ref WideVelocity a,
        ref WideVelocity b)
    {
        Wide armA = Along(point->NormalArmA, point->TangentArmA, _lane, movedA);
        Wide armB = Along(point->NormalArmB, point->TangentArmB, _lane, movedB);
        ContactFriction.WithRadii(_row, _lane, ref armA, ref armB);
        Wide massA = Wide.Load(_row->MassA + _lane);
        Wide massB = Wide.Load(_row->MassB + _lane);
        Wide iA = Wide.Load(_row->InertiaA + _lane) * armA;
        Wide iB = Wide.Load(_row->InertiaB + _lane) * armB;
        Wide slip = ContactFriction.SlipOf(ContactFriction.Slip(_row, _lane, a, b), a, b, armA, armB);
        Wide response = massA + massB + (iA * armA) + (iB * armB);
        Wide bound = Wide.Load(_row->Friction + _lane) * normal;
        Wide found = before - (slip / Wide.Max(response, Wide.Splat(float.Epsilon)));
        found = Wide.Max(Wide.Min(found, bound), Wide.Zero - bound);
        Wide p = found - before;
        Wide px = Wide.Load(_row->NormalY + _lane) * p;
        Wide py = Wide.Zero - (Wide.Load(_row->NormalX + _lane) * p);
        a.X = a.X - (massA * px);
        a.Y = a.Y - (massA * py);
        a.W = a.W + (iA * p);
        b.X = b.X + (massB * px);
        b.Y = b.Y + (massB * py);
        b.W = b.W - (iB * p);
        return found;
    }

    // With s = s0 + cos·N + sin·T for a turn, the arm of the spin is its derivative, cos·T - sin·N.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Across(float* tangent, float* normal, int lane, in WideDelta moved) =>
        (moved.Cos * Wide.Load(tangent + lane)) - (moved.Sin * Wide.Load(normal + lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Along(float* normal, float* tangent, int lane, in WideDelta moved) =>
        (moved.Cos * Wide.Load(normal + lane)) + (moved.Sin * Wide.Load(tangent + lane));
}
