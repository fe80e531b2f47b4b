using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Friction of a contact: two rows in turn, each within the cone of its point's normal impulse, at arms that reach from the turning cores to the surfaces.
/// </summary>
internal static unsafe class ContactFriction
{
    /// <summary>
    /// Two friction rows in turn; the second sees the first's change through the coupling of the tangent arms. Lanes that are
    /// not <paramref name="active"/> keep their impulses. The arms turn along as in the normal rows.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Solve(
        ContactBundle* row,
        int lane,
        ref WideVelocity a,
        ref WideVelocity b,
        in WideDelta movedA,
        in WideDelta movedB,
        Wide normal0,
        Wide normal1,
        WideMask active)
    {
        WideDelta nearA = TurnedArms.Limited(movedA);
        WideDelta nearB = TurnedArms.Limited(movedB);
        TurnedArms.Normal(&row->Point0, lane, nearA, nearB, out Wide armA0, out Wide armB0);
        TurnedArms.Normal(&row->Point1, lane, nearA, nearB, out Wide armA1, out Wide armB1);
        WithRadii(row, lane, ref armA0, ref armB0);
        WithRadii(row, lane, ref armA1, ref armB1);
        Wide slip = Slip(row, lane, a, b);
        Wide change0 = Find(row, &row->Point0, lane, SlipOf(slip, a, b, armA0, armB0), normal0, active);
        Wide slip1 = SlipOf(slip, a, b, armA1, armB1) + (Coupling(row, lane, armA0, armB0, armA1, armB1) * change0);
        Wide change1 = Find(row, &row->Point1, lane, slip1, normal1, active);
        ContactKernel.ApplyTangent(row, lane, ref a, ref b, change0, change1);
    }

    /// <summary>Turned normal arms, from the cores to the surfaces.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WithRadii(ContactBundle* row, int lane, ref Wide armA, ref Wide armB)
    {
        armA = armA + Wide.Load(row->RadiusA + lane);
        armB = armB - Wide.Load(row->RadiusB + lane);
    }

    /// <summary>How fast the centres pass each other along the surface.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Slip(ContactBundle* row, int lane, in WideVelocity a, in WideVelocity b) =>
        (Wide.Load(row->NormalY + lane) * (b.X - a.X)) - (Wide.Load(row->NormalX + lane) * (b.Y - a.Y));

    /// <summary>How fast the surfaces of a point do.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide SlipOf(Wide slip, in WideVelocity a, in WideVelocity b, Wide armA, Wide armB) => slip + ((a.W * armA) - (b.W * armB));

    /// <summary>How fast the second point slips for an impulse at the first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Coupling(ContactBundle* row, int lane, Wide armA0, Wide armB0, Wide armA1, Wide armB1) =>
        Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane)
            + (Wide.Load(row->InertiaA + lane) * armA0 * armA1) + (Wide.Load(row->InertiaB + lane) * armB0 * armB1);

    /// <summary>The response of a point to friction, 1/(mA + mB + iA·anA² + iB·anB²) with the arms of the surfaces. Of a point that does not exist it is any.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide TangentMass(ContactBundle* row, ContactPointLanes* point, int lane)
    {
        Wide armA = Wide.Load(point->NormalArmA + lane) + Wide.Load(row->RadiusA + lane);
        Wide armB = Wide.Load(point->NormalArmB + lane) - Wide.Load(row->RadiusB + lane);
        Wide m = Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane);
        return Wide.One / (m + (Wide.Load(row->InertiaA + lane) * (armA * armA)) + (Wide.Load(row->InertiaB + lane) * (armB * armB)));
    }

    /// <summary>The friction of a point within its cone.</summary>
    /// <returns>The change of its impulse; the bodies do not know yet.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Find(
        ContactBundle* row, ContactPointLanes* point, int lane, Wide slip, Wide normal, WideMask active)
    {
        Wide old = Wide.Load(point->Tangent + lane);
        Wide bound = Wide.Load(row->Friction + lane) * normal;
        Wide found = Wide.Max(Wide.Min(old - (TangentMass(row, point, lane) * slip), bound), Wide.Zero - bound);
        found = Wide.Select(active, found, old);
        found.Store(point->Tangent + lane);
        return found - old;
    }
}
