using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Friction of a contact: two rows in turn, each within the cone of its point's normal impulse, at arms that reach from the turning cores
/// to the surfaces.
/// </summary>
internal static unsafe class ContactFriction
{
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
    public static Wide SlipOf(Wide slip, in WideVelocity a, in WideVelocity b, Wide armA, Wide armB) =>
        slip + ((a.W * armA) - (b.W * armB));

    /// <summary>How fast the second point slips for an impulse at the first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Coupling(ContactBundle* row, int lane, Wide armA0, Wide armB0, Wide armA1, Wide armB1) =>
        Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane)
            + (Wide.Load(row->InertiaA + lane) * armA0 * armA1) + (Wide.Load(row->InertiaB + lane) * armB0 * armB1);

    /// <summary>
    /// The response of a point to friction, 1/(mA + mB + iA·anA² + iB·anB²) with the arms of the surfaces. Of a point that does not exist
    /// it is any.
    /// </summary>
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
        ContactBundle* row, ContactPointLanes* point, int lane, Wide slip, Wide normal)
    {
        Wide old = Wide.Load(point->Tangent + lane);
        Wide bound = Wide.Load(row->Friction + lane) * normal;
        Wide found = Wide.Max(Wide.Min(old - (TangentMass(row, point, lane) * slip), bound), Wide.Zero - bound);
        found.Store(point->Tangent + lane);
        return found - old;
    }
}
