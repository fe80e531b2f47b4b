using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>How many points the contacts of some bundles have. A type and not a flag: what is not there costs a pass nothing.</summary>
internal interface IContactPoints
{
    bool AreTwo { get; }
}

/// <summary>Two each, or one in some and two in others.</summary>
internal readonly struct TwoPoints : IContactPoints
{
    public bool AreTwo => true;
}

/// <summary>
/// One each, as in heaps of circles: a second point that does not exist is found not to push, and its arms and impulses are 0, so to leave
/// it out changes no bit.
/// </summary>
internal readonly struct OnePoint : IContactPoints
{
    public bool AreTwo => false;

    /// <summary>Whether it is so in all lanes of some bundles.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe bool Are(ContactBundle* row, int count)
    {
        for (; count > 0; count--, row = ContactBundle.Next(row))
        {
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                if (WideLanes.Bits(ContactBundle.Has(row, lane, ContactBundle.SingleMark)) != (1 << Wide.Count) - 1)
                {
                    return false;
                }
            }
        }

        return true;
    }
}
